package tellosimulator.world;

import tellosimulator.math.Vec3;

/**
 * The result of a collision of a body. Immutable; for any thread.
 *
 * @param touched what it touches; of several the one that it hit fastest
 * @param normal unit vector away from what it touches
 * @param speed how fast it came [m/s], 0 when it only rests or leans
 * @param position where the body is now, outside of what it touches [m]
 * @param velocity what is left of its velocity [m/s]
 */
public record Collision(
    Collidable touched, Vec3 normal, double speed, Vec3 position, Vec3 velocity) {

  /** Steepest ground on which a drone stands, as the cosine of its slope. Assumed: 45 degrees. */
  private static final double STEEPEST_GROUND = 0.7;

  /** Whether it is something to stand on. */
  public boolean onGround() {
    return normal.z() > STEEPEST_GROUND && touched.carries();
  }
}
