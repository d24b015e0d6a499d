package tellosimulator.physics;

import tellosimulator.math.Vec3;

/**
 * Estimates the push of the wind: the acceleration that the drone's own thrust and the drag of
 * still air do not explain. The estimate lags, so gusts still move the drone. In still air, the
 * estimate decays to exactly zero. One instance per drone; not thread-safe.
 */
final class WindEstimator {

  /**
   * Time constant of the lag [s]. Assumed: the time that a drone needs to tilt against the wind.
   */
  private static final double LAG = 0.4;

  /** An estimate smaller than this is set to zero [m/s²]. Decided: too small to have an effect. */
  private static final double NOTHING = 1e-6;

  private Vec3 push = Vec3.ZERO;

  /** Returns the estimated acceleration caused by the wind, in the room frame [m/s²]. */
  Vec3 push() {
    return push;
  }

  /**
   * Resets the estimate. Called while the drone is on the ground, because wind does not move it
   * there.
   */
  void reset() {
    push = Vec3.ZERO;
  }

  /**
   * Updates the estimate by a step.
   *
   * @param velocity the velocity of the drone, in the room frame [m/s]
   * @param wind the velocity of the air, in the room frame [m/s]
   * @param seconds the length of the step [s]
   */
  void update(Vec3 velocity, Vec3 wind, double seconds) {
    if (wind.equals(Vec3.ZERO) && push.equals(Vec3.ZERO)) {
      return;
    }
    Vec3 airspeed = velocity.minus(wind);
    Vec3 present =
        velocity.times(Integrator.drag(velocity)).plusScaled(airspeed, -Integrator.drag(airspeed));
    push = push.plusScaled(present.minus(push), seconds / LAG);
    if (push.norm() < NOTHING) {
      push = Vec3.ZERO;
    }
  }
}
