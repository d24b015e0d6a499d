package tellosimulator.benchmark;

import java.util.Locale;

/**
 * A line of the benchmark table.
 *
 * @param what is measured
 * @param target what shall be reached, or empty
 * @param measured what was reached
 * @param reached whether that is enough
 */
record Row(String what, String target, String measured, boolean reached) {

  /** A time that shall not be longer. */
  static Row atMost(String what, double targetMs, double measuredMs) {
    return new Row(
        what,
        String.format(Locale.ROOT, "at most %s ms", Double.toString(targetMs).replace(".0", "")),
        String.format(Locale.ROOT, "%.3f ms", measuredMs),
        measuredMs <= targetMs);
  }

  /** Something to compare with; nothing is promised. */
  static Row beside(String what, String measured) {
    return new Row(what, "", measured, true);
  }

  String markdown() {
    String verdict = reached ? target.isEmpty() ? "" : "yes" : "**no**";
    return "| %s | %s | %s | %s |".formatted(what, target, measured, verdict);
  }
}
