package tellosimulator.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
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
        .doesNotContain("<script");
  }

  @Test
  void whatDiffersIsMarkedAndNamed() throws Exception {
    Flight first = Flight.read(RecordingFixture.in(folder.resolve("a")));
    Path other = RecordingFixture.in(folder.resolve("b"));
    new RecordingFixture(other)
        .with(
            "events.jsonl",
            """
            {"t":4.0,"drone":1,"kind":"command","command":"takeoff"}
            {"t":9.5,"drone":1,"kind":"reply","command":"takeoff","reply":"error"}
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
