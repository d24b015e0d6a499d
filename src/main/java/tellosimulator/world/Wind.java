package tellosimulator.world;

import tellosimulator.math.Vec3;

/**
 * The motion of the air. It is the same everywhere in the room. Immutable.
 *
 * @param mean the mean velocity, in the room frame [m/s]
 * @param gusts the standard deviation of each component of the horizontal velocity [m/s]
 */
public record Wind(Vec3 mean, double gusts) {

  /** No wind. */
  public static final Wind CALM = new Wind(Vec3.ZERO, 0);

  /**
   * Upper limit both of the mean speed and of the gusts [m/s]. Decided: no drone can hover in such
   * a gale.
   */
  public static final double FASTEST = 20;

  /** Tolerance for rounding errors of a vector's norm [m/s]. */
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
