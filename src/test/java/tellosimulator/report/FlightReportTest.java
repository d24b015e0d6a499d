package tellosimulator.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.json.Json;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordingFixture;
import tellosimulator.words.Translation;

class FlightReportTest {

  private static final Pattern DATA =
      Pattern.compile("<script type=\"application/json\" id=\"data\">(.*?)</script>");

  @TempDir private Path folder;

  @Test
  void noTextOfAFlightIsMarkup() throws Exception {
    String html = html();

    assertThat(html).doesNotContain(RecordingFixture.MARKUP).doesNotContain("<b>gates</b>");
    assertThat(html).contains("<h1>Two &lt;b&gt;gates&lt;/b&gt;</h1>");
    assertThat(html.split("</script>", -1)).hasSize(3); // data and the page's own, then the rest
  }

  @Test
  void theDataSaysWhatTheFlightDid() throws Exception {
    Map<?, ?> data = data(html());

    assertThat(texts(data.get("entries"), "text"))
        .contains("takeoff", "forward 100", "took off", RecordingFixture.MARKUP);
    assertThat(texts(data.get("entries"), "why"))
        .contains("fly 100 cm forward", "`forward 100` is not over");
    assertThat(texts(data.get("marks"), "kind")).containsExactly("refused", "touched", "refused");
    assertThat(texts(data.get("badges"), "text"))
        .containsExactly(
            "Goals missed",
            "Touches: 1",
            "Refused: 2",
            "11.0 s from takeoff to the end",
            "7 commands");
    // at 9 s the drone was 50 cm on its way from -100 cm
    assertThat(((List<?>) data.get("marks")).get(0)).asString().contains("x=-50.0", "t=9.0");
  }

  @Test
  void thePageLoadsNothing() throws Exception {
    String html = html();

    assertThat(html).contains("default-src &#39;none&#39;; img-src data:;");
    assertThat(DATA.matcher(html).replaceFirst(""))
        .doesNotContainPattern("(?i)(src|href)=\"(?!data:|#)")
        .doesNotContainPattern("(?i)https?://(?!www\\.w3\\.org/2000/svg)")
        .doesNotContainPattern("\\{\\{")
        .doesNotContainPattern("(?i)\\son[a-z]+=");
  }

  /**
   * The path reaches at most 100 cm from the middle, and has a margin of one metre; the size of the
   * room is unknown.
   */
  @Test
  void ofARealDroneThePathIsShownWithoutARoom() throws Exception {
    new RecordingFixture(folder)
        .run("{\"format\":1,\"started\":4.0,\"realDrone\":\"192.168.10.1\"}")
        .samples(15);

    Map<?, ?> data = data(html(RecordedFlight.read(folder)));

    assertThat(data.get("room"))
        .isEqualTo(Map.of("width", 300.0, "depth", 400.0, "grid", 40.0, "measured", false));
    assertThat((List<?>) data.get("things")).isEmpty();
    assertThat((List<?>) ((Map<?, ?>) data.get("film")).get("times")).isEmpty();
    assertThat(texts(data.get("drones"), "number")).isNotEmpty();
  }

  @Test
  void withoutSamplesAndEventsThereIsStillAPage() throws Exception {
    new RecordingFixture(folder).run("{\"format\":1}");

    Map<?, ?> data = data(html(RecordedFlight.read(folder)));

    assertThat((List<?>) data.get("drones")).hasSize(1);
    assertThat((List<?>) data.get("entries")).isEmpty();
    assertThat((List<?>) data.get("remarks")).hasSize(1);
  }

  @Test
  void theDataSaysWhereGoalsAreAndWhenTheyWereReached() throws Exception {
    RecordingFixture.in(folder);
    new RecordingFixture(folder)
        .with(
            "scenario.yaml",
            """
            pads:
              - {id: 3, at: [100, 50]}
            goals:
              - reach: {at: [0, 50, 80], radius: 30}
              - land-on: {pad: 3}
            in-order: true
            """);

    Map<?, ?> data = data(html(RecordedFlight.read(folder)));

    List<?> goals = (List<?>) data.get("goalPlaces");
    assertThat(goals).hasSize(2);
    assertThat(goal(goals, 0))
        .containsEntry("number", 1L)
        .containsEntry("reached", 10.5)
        .containsEntry("radius", 30.0)
        .doesNotContainKey("landing");
    assertThat(goal(goals, 1))
        .containsEntry("x", 100.0)
        .containsEntry("y", 50.0)
        .containsEntry("landing", true)
        .doesNotContainKey("reached");
    assertThat(data.get("goalsInOrder")).isEqualTo(true);
    assertThat(data.get("markColors")).asString().contains("contact=#cf222e");
  }

  @SuppressWarnings("unchecked")
  private static Map<String, Object> goal(List<?> goals, int index) {
    return (Map<String, Object>) goals.get(index);
  }

  private String html() throws Exception {
    return html(RecordedFlight.read(RecordingFixture.in(folder)));
  }

  private static String html(RecordedFlight flight) {
    return new FlightReport(flight, new ReportTexts(Translation.ENGLISH)).html();
  }

  private static Map<?, ?> data(String html) {
    Matcher matcher = DATA.matcher(html);
    assertThat(matcher.find()).isTrue();
    return (Map<?, ?>) Json.value(matcher.group(1));
  }

  private static List<Object> texts(Object items, String name) {
    return ((List<?>) items).stream().<Object>map(item -> ((Map<?, ?>) item).get(name)).toList();
  }
}
