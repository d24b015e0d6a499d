package tellosimulator.goal;

import java.util.OptionalInt;

/**
 * The terms of a goal, which are common to all kinds: who must reach it, and what it is worth.
 * Immutable.
 *
 * @param drone the number of the drone that must reach the goal; empty if any drone may
 * @param points the points that are won by reaching it; 0 if the goal is worth no points
 */
public record Terms(OptionalInt drone, double points) {

  /** Maximum points of a goal, of a penalty and of a total. Decided: ten times a percentage. */
  public static final double MOST_POINTS = 1000;

  /** Any drone may reach the goal, for no points. */
  public static final Terms ANY = new Terms(OptionalInt.empty(), 0);

  public Terms {
    if (!(points >= 0 && points <= MOST_POINTS)) {
      throw new IllegalArgumentException(
          "points is " + points + ", but must be from 0 to " + MOST_POINTS);
    }
  }

  /** Returns the terms of a goal that one drone must reach, for no points. */
  public static Terms of(int drone) {
    return new Terms(OptionalInt.of(drone), 0);
  }

  /** Returns a copy for another drone. */
  public Terms forDrone(OptionalInt newDrone) {
    return new Terms(newDrone, points);
  }

  /** Returns a copy with other points. */
  public Terms worth(double newPoints) {
    return new Terms(drone, newPoints);
  }
}
