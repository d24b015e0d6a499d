package tellosimulator.report;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;
import java.util.List;
import java.util.stream.Collectors;
import tellosimulator.files.IrregularFileException;
import tellosimulator.json.Json;
import tellosimulator.recording.RecordedFlight;

/**
 * A report of a flight: one HTML file that holds everything it shows, and loads nothing. For any
 * thread.
 *
 * <p>All that comes from the recording is data in it. A browser runs nothing but the page's own
 * script, because its policy names that by its digest.
 */
public final class FlightReport {

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
    IrregularFileException.check(file);
    Files.writeString(file, html());
  }

  /** The whole page. */
  String html() {
    String style = HtmlTemplate.resource("report.css");
    String script = SCRIPTS.stream().map(HtmlTemplate::resource).collect(Collectors.joining("\n"));
    HtmlTemplate template = new HtmlTemplate(HtmlTemplate.resource("report.html"));
    texts.all().forEach((key, text) -> template.text("text." + key, text));
    return template
        .text("language", texts.language())
        .text("title", texts.of("title", heading()))
        .text("heading", heading())
        .text("footer", texts.of("footer", flight.run().program()))
        .text("policy", policy(style, script))
        .code("style", style)
        .code("script", script)
        .code("data", HtmlTemplate.escapedJson(Json.text(new ReportData(flight, texts).members())))
        .filled();
  }

  private String heading() {
    String scenario = flight.run().setting().scenario();
    return scenario.isEmpty() ? texts.of("no-scenario") : scenario;
  }

  /** Nothing may be loaded or sent, and no other script run. */
  private static String policy(String style, String script) {
    return "default-src 'none'; img-src data:; style-src '"
        + digest(style)
        + "'; script-src '"
        + digest(script)
        + "'; base-uri 'none'; form-action 'none'";
  }

  private static String digest(String code) {
    try {
      byte[] digest =
          MessageDigest.getInstance("SHA-256").digest(code.getBytes(StandardCharsets.UTF_8));
      return "sha256-" + Base64.getEncoder().encodeToString(digest);
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("each JDK has SHA-256", e);
    }
  }
}
