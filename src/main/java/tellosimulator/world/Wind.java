package tellosimulator.world;

import tellosimulator.math.Vec3;

/**
 * Moving air, the same everywhere in the room. Immutable.
 *
 * @param mean its mean velocity, room frame [m/s]
 * @param gusts standard deviation of each component of its level velocity [m/s]
 */
public record Wind(Vec3 mean, double gusts) {

  /** Air that does not move. */
  public static final Wind CALM = new Wind(Vec3.ZERO, 0);

  /** Fastest wind, and strongest gusts [m/s]. Decided: a gale, in which no drone can stay. */
  public static final double FASTEST = 20;

  /** What the sides of a triangle may be longer for rounding [m/s]. */
  private static final double ROUNDING = 1e-9;

  public Wind {
    if (!(mean.norm() <= FASTEST + ROUNDING)) {
      throw new IllegalArgumentException(
          "wind is " + mean.norm() + " m/s, but must be at most " + FASTEST);
    }
    if (!(gusts >= 0 && gusts <= FASTEST)) {
      throw new IllegalArgumentException(
          "gusts are " + gusts + " m/s, but must be from 0 to " + FASTEST);
    }
  }
}
