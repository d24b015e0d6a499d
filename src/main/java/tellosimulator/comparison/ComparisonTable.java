package tellosimulator.comparison;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.stream.Collectors;
import tellosimulator.command.WireText;
import tellosimulator.comparison.FlownCommand.Motion;
import tellosimulator.comparison.Tolerance.Aspect;

/** Two flights as a table of text: a row for each command, two values in each cell. */
public final class ComparisonTable {

  private static final List<String> HEADER =
      List.of(
          "drone",
          "command",
          "reply",
          "s",
          "forward cm",
          "left cm",
          "up cm",
          "turn deg",
          "verdict");

  /** Longest text of a command or reply that is shown whole. */
  private static final int LONGEST = 40;

  private final FlightComparison comparison;
  private final Tolerance tolerance;

  public ComparisonTable(FlightComparison comparison, Tolerance tolerance) {
    this.comparison = comparison;
    this.tolerance = tolerance;
  }

  /** Prints it, with a last line that says how many commands differ. */
  public void print(PrintStream out) {
    List<List<String>> rows = new ArrayList<>();
    rows.add(HEADER);
    comparison.pairs().forEach(pair -> rows.add(row(pair)));
    List<Integer> widths = new ArrayList<>();
    for (int column = 0; column < HEADER.size(); column++) {
      int here = column;
      widths.add(rows.stream().mapToInt(row -> row.get(here).length()).max().orElse(0));
    }
    for (List<String> row : rows) {
      StringBuilder line = new StringBuilder();
      for (int column = 0; column < HEADER.size(); column++) {
        line.append(
            String.format(Locale.ROOT, "%-" + (widths.get(column) + 2) + "s", row.get(column)));
      }
      out.println(line.toString().stripTrailing());
    }
    out.println(summary());
  }

  private String summary() {
    long differing =
        comparison.pairs().stream().filter(pair -> !pair.differing().isEmpty()).count();
    return String.format(
        Locale.ROOT,
        "%d of %d commands differ by more than %.0f %% or %.1f s, %.0f cm, %.0f degrees",
        differing,
        comparison.pairs().size(),
        100 * tolerance.share(),
        tolerance.seconds(),
        tolerance.centimeters(),
        tolerance.degrees());
  }

  private static List<String> row(CommandPair pair) {
    return List.of(
        Integer.toString(pair.drone()),
        shortened(pair.text()),
        both(pair, flown -> shortened(flown.command().reply().stripTrailing())),
        both(pair, flown -> seconds(flown.command().duration())),
        both(pair, flown -> whole(flown, Motion::forward)),
        both(pair, flown -> whole(flown, Motion::left)),
        both(pair, flown -> whole(flown, Motion::up)),
        both(pair, flown -> whole(flown, Motion::turn)),
        verdict(pair));
  }

  private static String both(CommandPair pair, Function<FlownCommand, String> value) {
    String first = pair.first().map(value).orElse("-");
    String second = pair.second().map(value).orElse("-");
    return first.equals(second) ? first : first + " | " + second;
  }

  private static String seconds(OptionalDouble seconds) {
    return seconds.isPresent() ? String.format(Locale.ROOT, "%.2f", seconds.getAsDouble()) : "-";
  }

  private static String whole(FlownCommand flown, Function<Motion, Double> part) {
    Optional<Motion> motion = flown.motion();
    return motion.map(part).map(value -> Long.toString(Math.round(value))).orElse("-");
  }

  private static String shortened(String text) {
    String shown = WireText.printable(text);
    return shown.length() <= LONGEST ? shown : shown.substring(0, LONGEST - 1) + "…";
  }

  private static String verdict(CommandPair pair) {
    if (pair.differing().contains(Aspect.MISSING)) {
      return pair.first().isPresent() ? "only in the first" : "only in the second";
    }
    return pair.differing().isEmpty()
        ? "alike"
        : pair.differing().stream()
            .sorted()
            .map(aspect -> aspect.name().toLowerCase(Locale.ROOT))
            .collect(Collectors.joining(", ", "differs: ", ""));
  }
}
