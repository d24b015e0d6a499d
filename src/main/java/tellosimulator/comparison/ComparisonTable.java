package tellosimulator.comparison;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import tellosimulator.command.WireText;
import tellosimulator.comparison.Tolerance.Aspect;

/**
 * Formats a comparison of two flights as a text table with one row for each command and two values
 * in each cell.
 */
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

  /** Maximum length of a command or reply in the table [characters]. Longer texts are shortened. */
  private static final int LONGEST = 40;

  private final FlightComparison comparison;
  private final Tolerance tolerance;

  public ComparisonTable(FlightComparison comparison, Tolerance tolerance) {
    this.comparison = comparison;
    this.tolerance = tolerance;
  }

  /** Prints the table, followed by a line with the number of commands that differ. */
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
    return String.format(
        Locale.ROOT,
        "%d of %d commands differ by more than %.0f %% or %.1f s, %.0f cm, %.0f degrees",
        comparison.differing(),
        comparison.pairs().size(),
        100 * tolerance.share(),
        tolerance.seconds(),
        tolerance.centimeters(),
        tolerance.degrees());
  }

  private static List<String> row(CommandPair pair) {
    List<String> row = new ArrayList<>();
    row.add(Integer.toString(pair.drone()));
    row.add(shortened(WireText.printable(pair.text())));
    for (ComparisonColumn column : ComparisonColumn.values()) {
      String first = cell(column, pair.first());
      String second = cell(column, pair.second());
      row.add(first.equals(second) ? first : first + " | " + second);
    }
    row.add(verdict(pair));
    return row;
  }

  private static String cell(ComparisonColumn column, Optional<FlownCommand> flown) {
    return flown
        .map(command -> shortened(column.text(command, Locale.ROOT)))
        .filter(text -> !text.isEmpty())
        .orElse("-");
  }

  private static String shortened(String text) {
    return text.length() <= LONGEST ? text : text.substring(0, LONGEST - 1) + "…";
  }

  private static String verdict(CommandPair pair) {
    if (pair.differing().contains(Aspect.MISSING)) {
      return pair.first().isPresent() ? "only in the first" : "only in the second";
    }
    return pair.alike()
        ? "alike"
        : pair.differing().stream()
            .sorted()
            .map(aspect -> aspect.name().toLowerCase(Locale.ROOT))
            .collect(Collectors.joining(", ", "differs: ", ""));
  }
}
