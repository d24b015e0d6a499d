package tellosimulator.goal;

import tellosimulator.math.Vec3;
import tellosimulator.world.Room;

/**
 * A ball around a place, or a circle on the floor. Immutable.
 *
 * @param place the middle, in the room frame [m]
 * @param radius the radius [m]
 */
public record GoalRegion(Vec3 place, double radius) {

  /** Minimum radius [m]. Decided: the accuracy of a move in behaviour {@code report}. */
  public static final double SMALLEST = 0.01;

  /**
   * Default radius [m]. Decided: larger than a hand's breadth, which would be too strict, and
   * smaller than an arm's length, which would be too lenient.
   */
  public static final double DEFAULT_RADIUS = 0.3;

  public GoalRegion {
    if (!(radius >= SMALLEST && radius <= Room.LONGEST)) {
      throw new IllegalArgumentException(
          "radius is " + radius + " m, but must be from " + SMALLEST + " to " + Room.LONGEST);
    }
  }

  /** Whether a position is in the ball. */
  boolean holds(Vec3 position) {
    return position.distanceTo(place) <= radius;
  }

  /** Whether a position is over or under the circle. */
  boolean holdsLevel(Vec3 position) {
    return position.minus(place).horizontal().norm() <= radius;
  }
}
