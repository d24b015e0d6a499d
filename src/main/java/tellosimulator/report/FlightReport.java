package tellosimulator.report;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import tellosimulator.files.AtomicFile;
import tellosimulator.json.Json;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.scenario.Gallery;

/**
 * A report of a flight: one self-contained HTML file that loads no other files. Thread-safe.
 *
 * <p>All recorded contents are embedded as data. The page's content security policy names the
 * digest of the page's own script, so a browser runs no other script.
 */
public final class FlightReport {

  /** The default file name in the folder of a recording. */
  public static final String FILE_NAME = "report.html";

  private static final List<String> SCRIPTS =
      List.of("flight.js", "commands.js", "plan.js", "charts.js", "film.js", "report.js");

  private final RecordedFlight flight;
  private final ReportTexts texts;

  public FlightReport(RecordedFlight flight, ReportTexts texts) {
    this.flight = flight;
    this.texts = texts;
  }

  /**
   * Writes the report.
   *
   * @throws IOException if it cannot be written
   */
  public void write(Path file) throws IOException {
    byte[] page = html().getBytes(StandardCharsets.UTF_8);
    AtomicFile.write(file, out -> out.write(page));
  }

  /** Returns the whole page. */
  public String html() {
    String style = HtmlTemplate.resource("report.css");
    String script = SCRIPTS.stream().map(HtmlTemplate::resource).collect(Collectors.joining("\n"));
    return HtmlTemplate.page("report.html", texts)
        .text("title", texts.of("title", heading()))
        .text("heading", heading())
        .text("footer", texts.of("footer", flight.run().program()))
        .ownCode(style, script)
        .code("data", HtmlTemplate.escapedJson(Json.text(new ReportData(flight, texts).members())))
        .filled();
  }

  private String heading() {
    String scenario = flight.run().setting().scenario();
    return scenario.isEmpty() ? texts.of("no-scenario") : Gallery.nameIn(scenario, texts.locale());
  }
}
