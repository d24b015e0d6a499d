package tellosimulator.benchmark;

import java.io.PrintStream;
import java.math.BigDecimal;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/**
 * A line of a table of what was measured.
 *
 * @param what is measured
 * @param target what shall be reached, or empty
 * @param measured what was reached
 * @param reached whether that is enough
 */
public record Measurement(String what, String target, String measured, boolean reached) {

  /** A time that shall not be longer. */
  public static Measurement atMost(String what, double targetMs, double measuredMs) {
    return new Measurement(
        what, bound(targetMs, "ms"), milliseconds(measuredMs), measuredMs <= targetMs);
  }

  private static String milliseconds(double value) {
    return String.format(Locale.ROOT, "%.3f ms", value);
  }

  /** Anything else that shall not be more. */
  public static Measurement atMost(String what, double target, double measured, String unit) {
    return new Measurement(
        what,
        bound(target, unit),
        String.format(Locale.ROOT, "%.2f %s", measured, unit),
        measured <= target);
  }

  private static String bound(double target, String unit) {
    return "at most "
        + BigDecimal.valueOf(target).stripTrailingZeros().toPlainString()
        + " "
        + unit;
  }

  /** The same measured several times: reached where the median is, so in more than half of them. */
  public static Measurement ofRuns(List<Measurement> runs) {
    Measurement first = runs.get(0);
    long reached = runs.stream().filter(Measurement::reached).count();
    return new Measurement(
        first.what,
        first.target,
        runs.stream().map(Measurement::measured).collect(Collectors.joining(", ")),
        2 * reached > runs.size());
  }

  /** Something to compare with; nothing is promised. */
  public static Measurement beside(String what, String measured) {
    return new Measurement(what, "", measured, true);
  }

  /** Writes a table in Markdown. */
  public static void print(List<Measurement> rows, PrintStream out) {
    out.println("| what | target | measured | reached |");
    out.println("|---|---|---|---|");
    rows.forEach(row -> out.println(row.markdown()));
  }

  private String markdown() {
    String verdict = reached ? target.isEmpty() ? "" : "yes" : "**no**";
    return "| %s | %s | %s | %s |".formatted(what, target, measured, verdict);
  }
}
