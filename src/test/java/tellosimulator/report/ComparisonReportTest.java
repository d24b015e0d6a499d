package tellosimulator.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.comparison.FlightComparison.Flight;
import tellosimulator.comparison.Tolerance;
import tellosimulator.recording.RecordingFixture;
import tellosimulator.report.ComparisonReport.NamedFlight;
import tellosimulator.words.Translation;

class ComparisonReportTest {

  @TempDir private Path folder;

  @Test
  void aFlightIsLikeItselfAndNoTextOfItIsMarkup() throws Exception {
    Flight flight = Flight.read(RecordingFixture.in(folder.resolve("a")));

    String html = html(flight, flight);

    assertThat(html)
        .contains("<span class=\"badge good\">all 7 commands alike</span>")
        .contains("<title>&lt;b&gt; and other</title>")
        .doesNotContain(RecordingFixture.MARKUP)
        .doesNotContain("<script")
        .contains("script-src &#39;none&#39;")
        .doesNotContain("unsafe");
  }

  @Test
  void chartsReachAsFarAsTheirLines() throws Exception {
    Path flown = RecordingFixture.in(folder.resolve("a"));
    new RecordingFixture(flown)
        .with("wire.jsonl", state(1, 5.0, 80) + state(1, 6.0, 90) + state(2, 6.0, 250));
    Flight flight = Flight.read(flown);

    assertThat(html(flight, flight)).contains("<span>90 cm</span><span>80 cm</span>");
  }

  private static String state(int drone, double time, int height) {
    return String.format(
        Locale.ROOT,
        "{\"t\":%.3f,\"drone\":%d,\"kind\":\"state\","
            + "\"text\":\"yaw:0;vgx:0;vgy:0;vgz:0;h:%d;\"}%n",
        time,
        drone,
        height);
  }

  @Test
  void whatDiffersIsMarkedAndNamed() throws Exception {
    Flight first = Flight.read(RecordingFixture.in(folder.resolve("a")));
    Path other = RecordingFixture.in(folder.resolve("b"));
    new RecordingFixture(other)
        .with(
            "events.jsonl",
            """
            {"t":4.0,"drone":1,"kind":"command","command":"takeoff","number":1}
            {"t":9.5,"drone":1,"kind":"reply","command":"takeoff","number":1,"reply":"error"}
            """);

    assertThat(html(first, Flight.read(other)))
        .contains("<span class=\"badge bad\">7 of 7 commands differ</span>")
        .contains("<tr class=\"wrong\"><td>1</td><td>takeoff</td><td>ok</td><td>error</td>")
        .contains("<td>reply, duration</td>")
        .contains("<td>only in A</td>");
  }

  private static String html(Flight first, Flight second) {
    return new ComparisonReport(
            new NamedFlight("<b>", first),
            new NamedFlight("other", second),
            Tolerance.DEFAULT,
            new ReportTexts(Translation.ENGLISH))
        .html();
  }
}
