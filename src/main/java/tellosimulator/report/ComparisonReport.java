package tellosimulator.report;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import tellosimulator.command.WireText;
import tellosimulator.comparison.CommandPair;
import tellosimulator.comparison.ComparisonColumn;
import tellosimulator.comparison.FlightComparison;
import tellosimulator.comparison.FlightComparison.Flight;
import tellosimulator.comparison.FlownCommand;
import tellosimulator.comparison.Tolerance;
import tellosimulator.comparison.Tolerance.Aspect;
import tellosimulator.files.AtomicFile;

/**
 * A comparison of two flights as one HTML file with charts of both flights and a table of their
 * commands. The page runs no script. Thread-safe.
 */
public final class ComparisonReport {

  /** A flight and its name for users. */
  public record NamedFlight(String name, Flight flight) {

    /** Creates a flight that is named after its folder. */
    public static NamedFlight of(Path folder, Flight flight) {
      return new NamedFlight(String.valueOf(folder.toAbsolutePath().getFileName()), flight);
    }
  }

  private final NamedFlight first;
  private final NamedFlight second;
  private final FlightComparison comparison;
  private final Tolerance tolerance;
  private final ReportTexts texts;

  /**
   * Creates the page for two flights.
   *
   * @param tolerance the tolerance of the comparison
   */
  public ComparisonReport(
      NamedFlight first, NamedFlight second, Tolerance tolerance, ReportTexts texts) {
    this.first = first;
    this.second = second;
    this.tolerance = tolerance;
    this.texts = texts;
    comparison = FlightComparison.of(first.flight(), second.flight(), tolerance);
  }

  /**
   * Writes the page.
   *
   * @throws IOException if it cannot be written
   */
  public void write(Path file) throws IOException {
    byte[] page = html().getBytes(StandardCharsets.UTF_8);
    AtomicFile.write(file, out -> out.write(page));
  }

  /** Returns the whole page. */
  String html() {
    String style =
        HtmlTemplate.resource("report.css") + "\n" + HtmlTemplate.resource("comparison.css");
    return HtmlTemplate.page("comparison.html", texts)
        .text("title", texts.of("comparison.title", first.name(), second.name()))
        .text("first", first.name())
        .text("second", second.name())
        .text("state", comparison.alike() ? "good" : "bad")
        .text("verdict", summary())
        .text("tolerance", tolerance())
        .ownCode(style, "")
        .code("charts", new ComparisonCharts(first.flight(), second.flight(), texts).markup())
        .code("rows", comparison.pairs().stream().map(this::row).collect(Collectors.joining("\n")))
        .filled();
  }

  private String summary() {
    return comparison.alike()
        ? texts.of("comparison.alike", comparison.pairs().size())
        : texts.of("comparison.differing", comparison.differing(), comparison.pairs().size());
  }

  private String tolerance() {
    return texts.of(
        "comparison.tolerance",
        Math.round(100 * tolerance.share()),
        tolerance.seconds(),
        Math.round(tolerance.centimeters()),
        Math.round(tolerance.degrees()));
  }

  private String row(CommandPair pair) {
    List<String> cells = new ArrayList<>();
    cells.add(Integer.toString(pair.drone()));
    cells.add(WireText.printable(pair.text()));
    for (ComparisonColumn column : ComparisonColumn.values()) {
      cells.add(cell(column, pair.first()));
      cells.add(cell(column, pair.second()));
    }
    cells.add(verdict(pair));
    return cells.stream()
        .map(cell -> "<td>" + HtmlTemplate.escaped(cell) + "</td>")
        .collect(Collectors.joining("", pair.alike() ? "<tr>" : "<tr class=\"wrong\">", "</tr>"));
  }

  private String cell(ComparisonColumn column, Optional<FlownCommand> flown) {
    return flown.map(command -> column.text(command, texts.locale())).orElse("");
  }

  private String verdict(CommandPair pair) {
    if (pair.differing().contains(Aspect.MISSING)) {
      return texts.of(
          pair.first().isPresent() ? "comparison.only-first" : "comparison.only-second");
    }
    return pair.alike()
        ? texts.of("comparison.row-alike")
        : pair.differing().stream()
            .sorted()
            .map(aspect -> "comparison.aspect." + aspect.name().toLowerCase(Locale.ROOT))
            .map(texts::of)
            .collect(Collectors.joining(", "));
  }
}
