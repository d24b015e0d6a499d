package tellosimulator.wire;

import java.util.List;

/** Every known fact about the text interface, and whether the tables show it. */
final class FactIndex {

  private static final String ELSEWHERE = "elsewhere: ";
  private static final String MISSING = "missing: ";

  /**
   * A fact.
   *
   * @param id its name in the rows
   * @param summary a few words
   * @param status empty if rows show it, otherwise the reason why none does
   */
  record Fact(String id, String summary, String status) {

    boolean shown() {
      return status.isEmpty();
    }

    /** Returns whether it has no effect on the simulator's wire. */
    boolean elsewhere() {
      return status.startsWith(ELSEWHERE);
    }

    /** Returns whether it applies to the simulator but is not implemented. */
    boolean missing() {
      return status.startsWith(MISSING);
    }

    /** Returns the reason why no row shows it. */
    String reason() {
      return status.substring(status.indexOf(' ') + 1);
    }
  }

  private FactIndex() {}

  static List<Fact> facts() {
    return WireTable.lines(WireTable.DIRECTORY.resolve("facts.index")).stream()
        .filter(line -> !line.isBlank() && !line.startsWith("#"))
        .map(FactIndex::fact)
        .toList();
  }

  private static Fact fact(String line) {
    List<String> cells = WireTable.cells(line);
    if (cells.size() != 3) {
      throw new IllegalArgumentException(
          "facts.index: expected `id | summary | status`, found `" + line + "`");
    }
    return new Fact(cells.get(0), cells.get(1), cells.get(2));
  }
}
