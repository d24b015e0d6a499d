package tellosimulator.goal;

import tellosimulator.math.Vec3;
import tellosimulator.world.Room;

/**
 * A ball around a place; on the floor, a circle. Immutable.
 *
 * @param place room frame [m]
 * @param radius metres
 */
public record GoalRegion(Vec3 place, double radius) {

  /** Smallest radius [m]. Decided: the accuracy of a move in {@code report}. */
  public static final double SMALLEST = 0.01;

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
