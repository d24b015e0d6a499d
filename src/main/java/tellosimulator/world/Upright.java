package tellosimulator.world;

import java.util.Optional;
import tellosimulator.math.Vec3;
import tellosimulator.world.Solid.Exit;

/**
 * What upright bodies have in common: a hull gets out of them sidewards, or over or under them, the
 * way it came in.
 *
 * @param bottom of the body, room frame [m]
 * @param top of the body, room frame [m]
 */
record Upright(double bottom, double top) {

  /** A hull that was this near to the top was over it [m]. Decided: errors of rounding. */
  private static final double TOUCHING = 1e-9;

  private static final Vec3 DOWN = Vec3.UP.times(-1);

  /**
   * The way out.
   *
   * @param sidewards the way out to the side; a depth of 0 or less if the hull is beside the body
   * @param wasBeside whether it was beside it before
   */
  Optional<Exit> exit(Vec3 position, Vec3 before, Hull hull, Exit sidewards, boolean wasBeside) {
    double over = top - position.z();
    double under = position.z() + hull.height() - bottom;
    if (over <= 0 || under <= 0 || sidewards.depth() <= 0) {
      return Optional.empty();
    }
    if (wasBeside) {
      return Optional.of(sidewards);
    }
    if (before.z() >= top - TOUCHING) {
      return Optional.of(new Exit(Vec3.UP, over));
    }
    if (before.z() + hull.height() <= bottom + TOUCHING) {
      return Optional.of(new Exit(DOWN, under));
    }
    boolean passable = bottom >= hull.height(); // or there is only the floor below
    return Optional.of(shortest(sidewards, over, passable ? under : Double.POSITIVE_INFINITY));
  }

  /** For a hull that was in the body already. */
  private static Exit shortest(Exit sidewards, double over, double under) {
    if (sidewards.depth() <= Math.min(over, under)) {
      return sidewards;
    }
    return over <= under ? new Exit(Vec3.UP, over) : new Exit(DOWN, under);
  }

  /**
   * Where a ray is between bottom and top.
   *
   * @return the distances at which it comes in and goes out; the first is greater if it never is
   */
  double[] between(Vec3 origin, Vec3 direction) {
    if (direction.z() == 0) {
      boolean within = origin.z() >= bottom && origin.z() <= top;
      return within
          ? new double[] {Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY}
          : new double[] {Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};
    }
    double a = (bottom - origin.z()) / direction.z();
    double b = (top - origin.z()) / direction.z();
    return new double[] {Math.min(a, b), Math.max(a, b)};
  }

  /**
   * The distance at which a ray comes in; 0 if it begins inside, infinite if it never is inside.
   */
  static double entry(double in, double out) {
    return in > out || out < 0 ? Double.POSITIVE_INFINITY : Math.max(0, in);
  }
}
