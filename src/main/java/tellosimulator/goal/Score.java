package tellosimulator.goal;

import java.util.List;
import tellosimulator.words.Phrase;

/**
 * The points of an attempt. Immutable.
 *
 * @param entries why points were won and lost, in order
 * @param points the total, within the limits of the challenge
 * @param of the points of a perfect attempt
 */
public record Score(List<Entry> entries, double points, double of) {

  /** Number of rounding steps in a point. Decided: a hundredth is the finest that is shown. */
  private static final double PRECISION = 100;

  /**
   * Points that were won or lost.
   *
   * @param second the time since the first takeoff [s]; 0 before it
   * @param points negative if they were lost
   */
  public record Entry(double second, double points, Phrase why) {
    public Entry {
      points = rounded(points);
    }
  }

  public Score {
    entries = List.copyOf(entries);
  }

  /** Returns the score of a challenge after some entries. */
  static Score of(Challenge challenge, List<Entry> entries) {
    Scoring scoring = challenge.scoring().orElse(Scoring.GOALS_ONLY);
    double goals = challenge.goals().stream().mapToDouble(goal -> goal.terms().points()).sum();
    double bonus = scoring.bonus().map(Scoring.Bonus::points).orElse(0.0);
    double total = entries.stream().mapToDouble(Entry::points).sum();
    return new Score(
        entries,
        rounded(scoring.limits().limited(total)),
        rounded(scoring.limits().limited(goals + bonus)));
  }

  private static double rounded(double points) {
    return Math.rint(points * PRECISION) / PRECISION + 0.0; // no negative zero
  }

  /** Describes the score in one line: {@code score: 25 of 40 points}. */
  public Phrase phrase() {
    return Phrase.of("score: %s of %s points", number(points), number(of));
  }

  /** Describes a number of points, such as {@code 2.5 points}. */
  public static Phrase points(double points) {
    return points == 1 ? Phrase.of("1 point") : Phrase.of("%s points", number(points));
  }

  /** Formats a number of points with as many decimals as it has, but at most two. */
  public static Phrase number(double points) {
    double rounded = rounded(points);
    if (rounded == Math.rint(rounded)) {
      return Phrase.of("%.0f", rounded);
    }
    boolean tenths = rounded * 10 == Math.rint(rounded * 10);
    return tenths ? Phrase.of("%.1f", rounded) : Phrase.of("%.2f", rounded);
  }
}
