package tellosimulator.physics;

import tellosimulator.math.Attitude;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.Motion;
import tellosimulator.physics.Integrator.Forces;

/**
 * The dynamics of a quadcopter: thrust along the body's z axis, gravity, drag against the air, and
 * a second-order attitude response. The tilt, the accelerometer readings, and the trajectory of a
 * flip result from these dynamics. One instance per drone; not thread-safe. The same inputs give a
 * bit-identical motion.
 */
public final class QuadcopterDynamics {

  private static final double GREATEST_THRUST = DroneSpec.MAX_THRUST_RATIO * DroneSpec.GRAVITY;

  private final PositionLoop positionLoop = new PositionLoop();
  private final AttitudeLoop attitudeLoop = new AttitudeLoop();
  private final Integrator integrator = new Integrator();
  private final WindEstimator windEstimator = new WindEstimator();

  /**
   * Returns the motion after a step, without regard to obstacles, and updates the wind estimate.
   *
   * @param wind the velocity of the air, in the room frame [m/s]
   * @param seconds the length of the step [s]
   */
  public Motion advance(Motion motion, Setpoint setpoint, Vec3 wind, double seconds) {
    Motion next = integrator.step(motion, forces(motion, setpoint, wind), seconds);
    windEstimator.update(motion.velocity(), wind, seconds);
    return next;
  }

  /**
   * Replaces {@link #advance} in a step in which the drone rests with its motors off: the drone
   * does not move, and the wind estimate is reset.
   */
  public void rest() {
    windEstimator.reset();
  }

  /** Whether the drone's own sensors detect that the wind is pushing it. */
  public boolean pushed() {
    return !windEstimator.push().equals(Vec3.ZERO);
  }

  private Forces forces(Motion motion, Setpoint setpoint, Vec3 wind) {
    if (setpoint instanceof Setpoint.Track track) {
      Vec3 wanted = positionLoop.thrust(track, motion, windEstimator.push());
      double along = wanted.dot(motion.attitude().up());
      double thrust = Math.max(0, Math.min(GREATEST_THRUST, along));
      return new Forces(thrust, attitudeLoop.towards(wanted, track.heading(), motion), wind);
    }
    if (setpoint instanceof Setpoint.Spin spin) {
      double thrust = spin.thrustRatio() * DroneSpec.GRAVITY;
      return new Forces(thrust, attitudeLoop.towards(spin, motion), wind);
    }
    return new Forces(0, Vec3.ZERO, wind);
  }

  /**
   * The outer loop. It computes the required thrust, as an acceleration in the room frame, from the
   * actual and the target position and velocity. Immutable.
   */
  private static final class PositionLoop {

    /**
     * Horizontal position gain [1/s]. Assumed: together with the velocity gain, it gives a
     * well-damped response.
     */
    private static final double LEVEL_POSITION_GAIN = 2.2;

    /**
     * Horizontal velocity gain [1/s]. Assumed: less than a third of the frequency of the tilt
     * response, so that the inner loop is faster than the outer one.
     */
    private static final double LEVEL_VELOCITY_GAIN = 4;

    /**
     * Vertical position gain [1/s]. Assumed: stiffer than the horizontal gain, because thrust
     * responds at once.
     */
    private static final double VERTICAL_POSITION_GAIN = 3;

    /**
     * Vertical velocity gain [1/s]. Assumed: stiffer for the same reason as the vertical position
     * gain.
     */
    private static final double VERTICAL_VELOCITY_GAIN = 8;

    /** Maximum speed at which a position error is corrected [m/s]. Assumed. */
    private static final double FASTEST_CORRECTION = 1;

    private static final double TAN_MAX_TILT = StrictMath.tan(DroneSpec.MAX_TILT);

    /** Minimum vertical thrust per unit of mass [m/s²]. */
    private static final double LEAST_LIFT = 0.3 * DroneSpec.GRAVITY;

    /** Maximum vertical thrust per unit of mass [m/s²]. */
    private static final double GREATEST_LIFT = DroneSpec.MAX_THRUST_RATIO * DroneSpec.GRAVITY;

    /**
     * Returns the required thrust per unit of mass, in the room frame [m/s²].
     *
     * @param push the estimated push of the wind, in the room frame [m/s²]
     */
    Vec3 thrust(Setpoint.Track target, Motion motion, Vec3 push) {
      Vec3 error = target.position().minus(motion.position());
      Vec3 level = error.horizontal().times(LEVEL_POSITION_GAIN).limitedTo(FASTEST_CORRECTION);
      double vertical =
          Math.max(
              -FASTEST_CORRECTION,
              Math.min(FASTEST_CORRECTION, error.z() * VERTICAL_POSITION_GAIN));
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

  /**
   * The inner loop. It computes an angular acceleration in the body frame from the actual and the
   * target attitude, as a limited second-order response. It caches the quaternion of the last
   * heading, because headings seldom change. One instance per drone; not thread-safe.
   */
  private static final class AttitudeLoop {

    private static final double TILT_STIFFNESS =
        DroneSpec.TILT_FREQUENCY * DroneSpec.TILT_FREQUENCY;
    private static final double TILT_DAMPING = 2 * DroneSpec.DAMPING * DroneSpec.TILT_FREQUENCY;
    private static final double YAW_STIFFNESS = DroneSpec.YAW_FREQUENCY * DroneSpec.YAW_FREQUENCY;
    private static final double YAW_DAMPING = 2 * DroneSpec.DAMPING * DroneSpec.YAW_FREQUENCY;

    /**
     * Gain of the angular rate in a spin [1/s]. Assumed: the spin reaches its full rate within 0.1
     * s.
     */
    private static final double SPIN_GAIN = 30;

    private double heading;
    private Attitude headingTurn = Attitude.LEVEL;

    /**
     * Returns the angular acceleration that turns the body towards the direction of {@code thrust}
     * and the nose towards the target heading.
     */
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

    /** Returns the angular acceleration that brings the drone to the rate of a spin. */
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
}
