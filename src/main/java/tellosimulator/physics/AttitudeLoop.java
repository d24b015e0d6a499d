package tellosimulator.physics;

import tellosimulator.math.Attitude;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.Motion;

/**
 * The inner loop: from the attitude that is and shall be to an angular acceleration in the body
 * frame, as a second-order response with a limit. Keeps the last heading's quaternion, because
 * headings seldom change. For one drone and one thread.
 */
final class AttitudeLoop {

  private static final double TILT_STIFFNESS = DroneSpec.TILT_FREQUENCY * DroneSpec.TILT_FREQUENCY;
  private static final double TILT_DAMPING = 2 * DroneSpec.DAMPING * DroneSpec.TILT_FREQUENCY;
  private static final double YAW_STIFFNESS = DroneSpec.YAW_FREQUENCY * DroneSpec.YAW_FREQUENCY;
  private static final double YAW_DAMPING = 2 * DroneSpec.DAMPING * DroneSpec.YAW_FREQUENCY;

  /** Gain of the rate in a spin [1/s]. Assumed: full rate within 0.1 s. */
  private static final double SPIN_GAIN = 30;

  private double heading;
  private Attitude headingTurn = Attitude.LEVEL;

  /** Angular acceleration that brings the thrust to {@code thrust} and the nose to the heading. */
  Vec3 towards(Vec3 thrust, Setpoint.Heading target, Motion motion) {
    Attitude wanted = Attitude.tiltedTo(thrust.normalized()).after(turnTo(target.angle()));
    Vec3 error = motion.attitude().errorTo(wanted);
    Vec3 rate = motion.rate();
    return new Vec3(
            TILT_STIFFNESS * error.x() - TILT_DAMPING * rate.x(),
            TILT_STIFFNESS * error.y() - TILT_DAMPING * rate.y(),
            YAW_STIFFNESS * error.z() + YAW_DAMPING * (target.rate() - rate.z()))
        .limitedTo(DroneSpec.MAX_ANGULAR_ACCELERATION);
  }

  /** Angular acceleration that brings the turning rate to that of a spin. */
  Vec3 towards(Setpoint.Spin spin, Motion motion) {
    return spin.rate()
        .minus(motion.rate())
        .times(SPIN_GAIN)
        .limitedTo(DroneSpec.MAX_ANGULAR_ACCELERATION);
  }

  private Attitude turnTo(double angle) {
    if (angle != heading) {
      heading = angle;
      headingTurn = Attitude.ofHeading(angle);
    }
    return headingTurn;
  }
}
