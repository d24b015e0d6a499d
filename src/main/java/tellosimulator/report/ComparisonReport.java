package tellosimulator.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tellosimulator.command.WireText;
import tellosimulator.comparison.CommandPair;
import tellosimulator.comparison.FlightComparison;
import tellosimulator.comparison.FlightComparison.Flight;
import tellosimulator.comparison.FlownCommand;
import tellosimulator.comparison.FlownCommand.Motion;
import tellosimulator.comparison.Tolerance;
import tellosimulator.comparison.Tolerance.Aspect;
import tellosimulator.files.IrregularFileException;

/**
 * A comparison of two flights as one HTML file: charts of both, and a table of their commands. It
 * runs no script. For any thread.
 */
public final class ComparisonReport {

  /** A flight with the name that people know it by. */
  public record NamedFlight(String name, Flight flight) {

    /** With the name of its folder. */
    public static NamedFlight of(Path folder, Flight flight) {
      return new NamedFlight(String.valueOf(folder.toAbsolutePath().getFileName()), flight);
    }
  }

  private final NamedFlight first;
  private final NamedFlight second;
  private final Tolerance tolerance;
  private final ReportTexts texts;

  public ComparisonReport(
      NamedFlight first, NamedFlight second, Tolerance tolerance, ReportTexts texts) {
    this.first = first;
    this.second = second;
    this.tolerance = tolerance;
    this.texts = texts;
  }

  /**
   * Writes the page.
   *
   * @throws IOException if it cannot be written
   */
  public void write(Path file) throws IOException {
    IrregularFileException.check(file);
    Files.writeString(file, html());
  }

  /** The whole page. */
  String html() {
    FlightComparison comparison = FlightComparison.of(first.flight(), second.flight(), tolerance);
    String style =
        HtmlTemplate.resource("report.css") + "\n" + HtmlTemplate.resource("comparison.css");
    HtmlTemplate template = new HtmlTemplate(HtmlTemplate.resource("comparison.html"));
    texts.all().forEach((key, text) -> template.text("text." + key, text));
    return template
        .text("language", texts.language())
        .text("title", texts.of("comparison.title", first.name(), second.name()))
        .text("first", first.name())
        .text("second", second.name())
        .text("policy", "default-src 'none'; img-src data:; style-src 'unsafe-inline'")
        .text("state", comparison.alike() ? "good" : "bad")
        .text("verdict", summary(comparison.pairs()))
        .text("tolerance", tolerance())
        .code("style", style)
        .code("charts", new ComparisonCharts(first.flight(), second.flight(), texts).markup())
        .code("rows", comparison.pairs().stream().map(this::row).collect(Collectors.joining("\n")))
        .filled();
  }

  private String summary(List<CommandPair> pairs) {
    long differing = pairs.stream().filter(pair -> !pair.differing().isEmpty()).count();
    return differing == 0
        ? texts.of("comparison.alike", pairs.size())
        : texts.of("comparison.differing", differing, pairs.size());
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
    Stream<String> values =
        Stream.of(
                both(pair, flown -> WireText.printable(flown.command().reply().stripTrailing())),
                both(pair, flown -> seconds(flown.command().duration())),
                both(pair, flown -> whole(flown, Motion::forward)),
                both(pair, flown -> whole(flown, Motion::left)),
                both(pair, flown -> whole(flown, Motion::up)),
                both(pair, flown -> whole(flown, Motion::turn)))
            .flatMap(List::stream);
    Stream<String> cells =
        Stream.of(
                Stream.of(Integer.toString(pair.drone()), WireText.printable(pair.text())),
                values,
                Stream.of(verdict(pair)))
            .flatMap(Function.identity());
    return cells
        .map(cell -> "<td>" + HtmlTemplate.escaped(cell) + "</td>")
        .collect(
            Collectors.joining(
                "", pair.differing().isEmpty() ? "<tr>" : "<tr class=\"wrong\">", "</tr>"));
  }

  private static List<String> both(CommandPair pair, Function<FlownCommand, String> value) {
    return List.of(pair.first().map(value).orElse(""), pair.second().map(value).orElse(""));
  }

  private String seconds(OptionalDouble seconds) {
    return seconds.isPresent() ? String.format(texts.locale(), "%.2f", seconds.getAsDouble()) : "";
  }

  private static String whole(FlownCommand flown, Function<Motion, Double> part) {
    Optional<Motion> motion = flown.motion();
    return motion.map(part).map(value -> Long.toString(Math.round(value))).orElse("");
  }

  private String verdict(CommandPair pair) {
    if (pair.differing().contains(Aspect.MISSING)) {
      return texts.of(
          pair.first().isPresent() ? "comparison.only-first" : "comparison.only-second");
    }
    return pair.differing().isEmpty()
        ? texts.of("comparison.row-alike")
        : pair.differing().stream()
            .sorted()
            .map(aspect -> "comparison.aspect." + aspect.name().toLowerCase(Locale.ROOT))
            .map(texts::of)
            .collect(Collectors.joining(", "));
  }
}
