package tellosimulator.physics;

import tellosimulator.math.Attitude;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.Motion;

/** Semi-implicit Euler: velocities first, then positions by the new velocities. Immutable. */
final class Integrator {

  /**
   * Deceleration for each unit of speed [1/s], by linear and quadratic drag, at an airspeed [m/s].
   */
  static double drag(Vec3 airspeed) {
    return DroneSpec.LINEAR_DRAG + DroneSpec.QUADRATIC_DRAG * airspeed.norm();
  }

  /**
   * The motion a step later.
   *
   * @param seconds length of the step
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
   * What acts on the drone in a step.
   *
   * @param thrust along the body's z axis, for each unit of mass [m/s²]
   * @param angular acceleration in the body frame [rad/s²]
   * @param wind velocity of the air in the room frame [m/s]
   */
  record Forces(double thrust, Vec3 angular, Vec3 wind) {}
}
