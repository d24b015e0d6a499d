package tellosimulator.physics;

import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.Motion;

/**
 * The outer loop: from where the drone is and shall be to the thrust that it needs, as an
 * acceleration in the room frame. Immutable.
 */
final class PositionLoop {

  /** Level position gain [1/s]. Assumed: with the velocity gain well damped. */
  private static final double LEVEL_POSITION_GAIN = 2.2;

  /** Level velocity gain [1/s]. Assumed: below a third of the tilt's frequency. */
  private static final double LEVEL_VELOCITY_GAIN = 4;

  /** Vertical position gain [1/s]. Assumed: thrust answers at once, so stiffer than level. */
  private static final double VERTICAL_POSITION_GAIN = 3;

  /** Vertical velocity gain [1/s]. Assumed: as the position gain. */
  private static final double VERTICAL_VELOCITY_GAIN = 8;

  /** Fastest correction of a position error [m/s]. Assumed. */
  private static final double FASTEST_CORRECTION = 1;

  private static final double TAN_MAX_TILT = StrictMath.tan(DroneSpec.MAX_TILT);

  /** Least and greatest vertical thrust for each unit of mass [m/s²]. */
  private static final double LEAST_LIFT = 0.3 * DroneSpec.GRAVITY;

  private static final double GREATEST_LIFT = DroneSpec.MAX_THRUST_RATIO * DroneSpec.GRAVITY;

  /**
   * The thrust that is wanted, for each unit of mass [m/s²].
   *
   * @param push of the wind, as far as it is known [m/s²]
   */
  Vec3 thrust(Setpoint.Track target, Motion motion, Vec3 push) {
    Vec3 error = target.position().minus(motion.position());
    Vec3 level = error.horizontal().times(LEVEL_POSITION_GAIN).limitedTo(FASTEST_CORRECTION);
    double vertical =
        Math.max(
            -FASTEST_CORRECTION, Math.min(FASTEST_CORRECTION, error.z() * VERTICAL_POSITION_GAIN));
    Vec3 missing = target.velocity().plus(level.withZ(vertical)).minus(motion.velocity());
    Vec3 drag = target.velocity().times(Integrator.drag(target.velocity()));
    Vec3 wanted = target.acceleration().plus(drag).minus(push);
    double lift = DroneSpec.GRAVITY + wanted.z() + missing.z() * VERTICAL_VELOCITY_GAIN;
    lift = Math.max(LEAST_LIFT, Math.min(GREATEST_LIFT, lift));
    return wanted
        .plusScaled(missing, LEVEL_VELOCITY_GAIN)
        .horizontal()
        .limitedTo(lift * TAN_MAX_TILT)
        .withZ(lift);
  }
}
