package tellosimulator.goal;

import java.util.Map;
import java.util.Optional;

/**
 * The rules by which points are lost, or won in addition to those of the goals. Immutable.
 *
 * @param penalties the points that each infraction costs; an infraction that is missing costs none
 * @param par the time after which each second costs points; empty if time costs none
 * @param bonus the points for a fast flight; empty if there are none
 * @param limits the least and the most that the total can be
 */
public record Scoring(
    Map<Infraction, Double> penalties, Optional<Par> par, Optional<Bonus> bonus, Limits limits) {

  /** The rules of a challenge whose goals alone have points. */
  public static final Scoring GOALS_ONLY =
      new Scoring(Map.of(), Optional.empty(), Optional.empty(), Limits.DEFAULT);

  public Scoring {
    penalties = Map.copyOf(penalties);
    penalties.values().forEach(points -> check("penalty", points, Terms.MOST_POINTS));
  }

  /**
   * The time that a flight may take, counted from the first takeoff to the verdict.
   *
   * @param seconds the time without a penalty [s]
   * @param eachSecond the points that each further second costs; parts of a second cost their part
   */
  public record Par(double seconds, double eachSecond) {
    public Par {
      check("seconds", seconds, Challenge.LONGEST);
      check("eachSecond", eachSecond, Terms.MOST_POINTS);
    }
  }

  /**
   * Points for reaching all goals in a short time. They decrease linearly between two times, both
   * counted from the first takeoff.
   *
   * @param fullUntil the time until which all points are won [s]
   * @param noneFrom the time from which no points are won [s]; later than {@code fullUntil}
   */
  public record Bonus(double points, double fullUntil, double noneFrom) {
    public Bonus {
      check("points", points, Terms.MOST_POINTS);
      check("noneFrom", noneFrom, Challenge.LONGEST);
      if (!(fullUntil >= 0 && fullUntil < noneFrom)) {
        throw new IllegalArgumentException(
            "fullUntil is " + fullUntil + " s, but must be from 0 to less than " + noneFrom);
      }
    }

    /** Returns the points for reaching all goals after a time [s]. */
    double after(double seconds) {
      double share = (noneFrom - seconds) / (noneFrom - fullUntil);
      return points * Math.max(0, Math.min(1, share));
    }
  }

  /**
   * The limits of a total.
   *
   * @param most infinite for no limit
   */
  public record Limits(double least, double most) {

    /** Decided: penalties cannot make a total negative unless the scenario allows it. */
    public static final Limits DEFAULT = new Limits(0, Double.POSITIVE_INFINITY);

    public Limits {
      if (!(least >= -Terms.MOST_POINTS && least <= most)) {
        throw new IllegalArgumentException(
            "least is " + least + ", but must be from -" + Terms.MOST_POINTS + " to " + most);
      }
    }

    double limited(double points) {
      return Math.max(least, Math.min(most, points));
    }
  }

  private static void check(String name, double value, double most) {
    if (!(value >= 0 && value <= most)) {
      throw new IllegalArgumentException(name + " is " + value + ", but must be from 0 to " + most);
    }
  }
}
