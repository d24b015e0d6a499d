package tellosimulator.physics;

import tellosimulator.math.Vec3;

/**
 * Estimates how the wind pushes a drone: by what its accelerometer feels beyond its own thrust and
 * the drag of still air. The estimate is late, so gusts still move the drone. In still air it is
 * exactly zero. For one drone and one thread.
 */
final class WindEstimator {

  /** How late it is [s]. Assumed: as long as a drone takes to lean against a push. */
  private static final double LAG = 0.4;

  /** A push below this is forgotten when the air stands still [m/s²]. Decided: nobody feels it. */
  private static final double NOTHING = 1e-6;

  private Vec3 push = Vec3.ZERO;

  /** The estimated acceleration by the wind, room frame [m/s²]. */
  Vec3 push() {
    return push;
  }

  /** Stands on something, where the wind does not move it. */
  void reset() {
    push = Vec3.ZERO;
  }

  /**
   * Moves the estimate on by a step.
   *
   * @param velocity of the drone, room frame [m/s]
   * @param wind velocity of the air, room frame [m/s]
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
