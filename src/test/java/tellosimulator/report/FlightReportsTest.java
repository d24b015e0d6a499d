package tellosimulator.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.words.Translation;

class FlightReportsTest {

  @TempDir private Path folder;

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          flight.html, 1, flight.html
          flight.html, 2, flight-2.html
          a.b/c.d.htm, 3, a.b/c.d-3.htm
          .hidden,     2, .hidden-2
          flight,      2, flight-2
          """)
  void laterFlightsHaveANumber(Path file, int number, Path named) throws Exception {
    FlightReports reports = FlightReports.to(file, Optional.of(RecordingFolder.at(folder)));

    assertThat(reports.numbered(number)).isEqualTo(named);
  }

  @Test
  void aRunWithoutAFlightSaysSoOnceAndLeavesNothing() throws Exception {
    FlightReports reports = FlightReports.to(folder.resolve("x.html"), Optional.empty());
    Path kept = reports.recordings().path();
    List<String> said = new ArrayList<>();
    assertThat(kept).isDirectory();

    for (int i = 0; i < 2; i++) {
      boolean all =
          reports.write(
              () -> new ReportTexts(Translation.ENGLISH), file -> said.add("" + file), said::add);
      assertThat(all).isTrue();
    }

    assertThat(said).containsExactly("There is no report, because no drone took off.");
    assertThat(kept).doesNotExist();
    assertThat(folder).isEmptyDirectory();
  }
}
