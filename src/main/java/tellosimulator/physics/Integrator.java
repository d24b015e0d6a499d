package tellosimulator.physics;

import tellosimulator.math.Attitude;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.Motion;

/**
 * The semi-implicit Euler method. It updates the velocities first, and then the positions with the
 * new velocities. Immutable.
 */
final class Integrator {

  /**
   * Returns the deceleration per unit of speed [1/s] that linear and quadratic drag cause at a
   * given airspeed [m/s].
   */
  static double drag(Vec3 airspeed) {
    return DroneSpec.LINEAR_DRAG + DroneSpec.QUADRATIC_DRAG * airspeed.norm();
  }

  /**
   * Returns the motion after a step.
   *
   * @param seconds the length of the step [s]
   */
  Motion step(Motion motion, Forces forces, double seconds) {
    Vec3 airspeed = motion.velocity().minus(forces.wind());
    Vec3 felt = motion.attitude().up().times(forces.thrust()).plusScaled(airspeed, -drag(airspeed));
    Vec3 acceleration = felt.plusScaled(Vec3.UP, -DroneSpec.GRAVITY);
    Vec3 velocity = motion.velocity().plusScaled(acceleration, seconds);
    Vec3 position = motion.position().plusScaled(velocity, seconds);
    Vec3 rate = motion.rate().plusScaled(forces.angular(), seconds);
    Attitude attitude = motion.attitude().advancedBy(rate, seconds);
    return new Motion(position, velocity, felt, attitude, rate);
  }

  /**
   * The thrust, the angular acceleration and the wind that act on the drone in a step.
   *
   * @param thrust the thrust along the body's z axis, per unit of mass [m/s²]
   * @param angular the angular acceleration in the body frame [rad/s²]
   * @param wind the velocity of the air in the room frame [m/s]
   */
  record Forces(double thrust, Vec3 angular, Vec3 wind) {}
}
