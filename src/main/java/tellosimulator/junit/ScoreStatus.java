package tellosimulator.junit;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import tellosimulator.goal.Score;

/**
 * The points for the goals of the scenario. Immutable.
 *
 * @param points the total
 * @param of the points of a perfect flight
 * @param entries why points were won and lost, in order
 */
public record ScoreStatus(double points, double of, List<Entry> entries) {

  /**
   * Points that were won or lost.
   *
   * @param seconds the time since the first takeoff [simulated s]
   * @param points negative if they were lost
   * @param why the reason, in plain words
   */
  public record Entry(double seconds, double points, String why) {

    /** Describes the entry: {@code +10 at 12.3 s: reached goal 1 of 3: …}. */
    @Override
    public String toString() {
      String sign = points > 0 ? "+" : "";
      return String.format(
          Locale.ROOT, "%s%s at %.1f s: %s", sign, Score.number(points).english(), seconds, why);
    }
  }

  public ScoreStatus {
    entries = List.copyOf(entries);
  }

  static ScoreStatus of(Score score) {
    return new ScoreStatus(
        score.points(),
        score.of(),
        score.entries().stream()
            .map(entry -> new Entry(entry.second(), entry.points(), entry.why().english()))
            .toList());
  }

  /** Describes the total, and each entry in a line of its own. */
  @Override
  public String toString() {
    String total = Score.number(points).english() + " of " + Score.points(of).english();
    return entries.isEmpty()
        ? total
        : entries.stream()
            .map(Entry::toString)
            .collect(Collectors.joining("\n  ", total + "\n  ", ""));
  }
}
