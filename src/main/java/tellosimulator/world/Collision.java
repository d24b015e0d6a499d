package tellosimulator.world;

import tellosimulator.math.Vec3;

/**
 * The result of a collision of a body. Immutable.
 *
 * @param touched the touched object; if there are several, the object with the highest impact speed
 * @param normal the unit vector that points away from the touched object, in the room frame
 * @param speed the impact speed [m/s]; 0 if the body only rests or leans on the object
 * @param position the body's position after the collision, outside the touched object [m]
 * @param velocity the body's velocity after the collision [m/s]
 */
public record Collision(
    Collidable touched, Vec3 normal, double speed, Vec3 position, Vec3 velocity) {

  /**
   * Steepest ground on which a drone can stand, as the cosine of its slope. Assumed: 45 degrees.
   */
  private static final double STEEPEST_GROUND = 0.7;

  /** Whether a drone can stand on the touched object. */
  public boolean onGround() {
    return normal.z() > STEEPEST_GROUND && touched.carries();
  }
}
