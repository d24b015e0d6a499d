package tellosimulator.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordingFixture;
import tellosimulator.testing.Chromium;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;
import tellosimulator.words.Translation;

/** Opens a report as a file in a browser. */
@NeedsTool(Tool.CHROMIUM)
class ReportInBrowserTest {

  @TempDir private Path folder;

  private Path page;

  @BeforeEach
  void writeReport() throws Exception {
    page = folder.resolve("report.html");
    RecordedFlight flight = RecordedFlight.read(RecordingFixture.in(folder.resolve("flight")));
    new FlightReport(flight, new ReportTexts(Translation.ENGLISH)).write(page);
  }

  @Test
  void theAddressSaysWhichMomentIsShown() {
    String dom = dom(page, "#t=9");

    // 1 s at 50 cm/s from -100 cm on, and battery 90 - 9 s
    assertThat(shown(dom, "now")).isEqualTo("9.0 s");
    assertThat(shown(dom, "since")).isEqualTo("5.0 s after takeoff");
    assertThat(shown(dom, "place")).isEqualTo("x -50, y 50, z 80 cm · flying · forward 100");
    assertThat(shown(dom, "film-time")).isEqualTo("9.0 s");
    assertThat(chosenEntry(dom)).contains("cw 90").contains("is not over");
    assertThat(dom).contains("81<small> %</small>").contains("translate(-50 50) rotate(0)");
  }

  @Test
  void withoutAnAddressItBeginsAtTheTakeoff() {
    assertThat(shown(dom(page, ""), "now")).isEqualTo("4.0 s");
  }

  @Test
  void theSliderMovesEverything() throws IOException {
    String dom =
        dom(
            with(
                """
                const slider = document.getElementById('slider');
                slider.value = 12;
                slider.dispatchEvent(new Event('input'));
                slider.dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowRight', shiftKey: true}));
                """),
            "#t=9");

    // down from 80 cm at 40 cm/s, from 12 s on
    assertThat(shown(dom, "now")).isEqualTo("13.0 s");
    assertThat(shown(dom, "place")).isEqualTo("x 0, y 50, z 40 cm · landing");
    assertThat(chosenEntry(dom)).contains("<code>land</code>");
  }

  @Test
  void anEntryJumpsToItsMoment() throws IOException {
    String dom = dom(with("document.querySelectorAll('#commands button')[3].click();"), "");

    assertThat(shown(dom, "now")).isEqualTo("8.0 s");
    assertThat(chosenEntry(dom)).contains("forward 100");
  }

  @Test
  void chartsAndPlanAreToldInWords() {
    String dom = dom(page, "");

    assertThat(dom)
        .contains("aria-label=\"Height over time, at least 0 cm, at most 80 cm\"")
        .contains("aria-label=\"Battery over time, at least 75 %, at most 86 %\"")
        .contains("aria-label=\"The room from above, 500 cm wide and 600 cm deep");
  }

  @Test
  void aGoalBecomesGreenWhenItIsReached() throws Exception {
    Path goals = RecordingFixture.in(folder.resolve("goals"));
    new RecordingFixture(goals)
        .with(
            "scenario.yaml",
            """
            pads: [{id: 3, at: [100, 50]}]
            goals: [{reach: {at: [0, 50, 80]}}, {land-on: {pad: 3}}]
            in-order: true
            """);
    new FlightReport(RecordedFlight.read(goals), new ReportTexts(Translation.ENGLISH)).write(page);

    assertThat(states(dom(page, "#t=9"))).containsExactly("active", "later");
    assertThat(states(dom(page, "#t=11")))
        .as("reached at 10.5 s")
        .containsExactly("done", "active");
  }

  /** Returns the states of the goals' places. */
  private static List<String> states(String dom) {
    return Pattern.compile("<g class=\"goal\"[^>]*data-state=\"([a-z]+)\"")
        .matcher(dom)
        .results()
        .map(found -> found.group(1))
        .toList();
  }

  /** Checks escaping with the page's policy, and without it. */
  @Test
  void noTextOfACommandRunsAsCode() throws IOException {
    for (Path each : new Path[] {page, with("")}) {
      String dom = dom(each, "#t=11");

      assertThat(dom).contains("<title>Two &lt;b&gt;gates&lt;/b&gt; – flight report</title>");
      assertThat(chosenEntry(dom))
          .contains("&lt;/script&gt;&lt;script&gt;document.title='run'&lt;/script&gt;");
    }
  }

  @Test
  void itIsUsableSoon() throws IOException {
    String dom = dom(with("document.body.dataset.ready = Math.round(performance.now());"), "");

    Matcher ready = Pattern.compile("data-ready=\"(\\d+)\"").matcher(dom);
    assertThat(ready.find()).isTrue();
    // the goal is 1 s, but the test machine may be busy
    assertThat(Integer.parseInt(ready.group(1))).isLessThan(5_000);
  }

  private String dom(Path file, String anchor) {
    return Chromium.dom(file, anchor, folder);
  }

  /** Copies the page with one more script, which its policy would block. */
  private Path with(String script) throws IOException {
    String html =
        Files.readString(page)
            .replaceFirst("<meta http-equiv=\"Content-Security-Policy\"[^>]*>", "")
            .replace("</body>", "<script>" + script + "</script></body>");
    return Files.writeString(folder.resolve("copy.html"), html);
  }

  private static String shown(String dom, String id) {
    Matcher matcher = Pattern.compile("id=\"" + id + "\"[^>]*>([^<]*)<").matcher(dom);
    assertThat(matcher.find()).as("an element %s", id).isTrue();
    return matcher.group(1);
  }

  private static String chosenEntry(String dom) {
    int at = dom.indexOf("aria-current=\"true\"");
    assertThat(at).as("a chosen entry").isPositive();
    return dom.substring(at, dom.indexOf("</button>", at));
  }
}
