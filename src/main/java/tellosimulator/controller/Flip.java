package tellosimulator.controller;

import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.Motion;
import tellosimulator.physics.Setpoint;
import tellosimulator.words.Phrase;

/**
 * A flip. The drone jumps up, turns once about a body axis with little thrust, and recovers. It
 * then hovers at the initial height, a short distance away in the direction of the flip.
 */
final class Flip implements Maneuver {

  /** Upward acceleration of the jump [m/s²]. Assumed: the loop must clear the floor. */
  private static final double JUMP_ACCELERATION = 9;

  /** Duration of the jump [s]. Assumed: the loop must clear the floor. */
  private static final double JUMP_TIME = 0.22;

  /** Thrust during the turn, as a multiple of the weight. Assumed: the loop is small. */
  private static final double LOOP_THRUST = 0.25;

  /** Remaining angle of the turn at which the drone begins to recover [rad]. Assumed. */
  private static final double CATCH_ANGLE = 0.9;

  /**
   * Distance from the start to the end, in the direction of the flip [m]. Measured: about 30 cm.
   */
  private static final double ADVANCE = 0.30;

  /**
   * Time from the first motion to the end of the plan [s]. The reply then follows about 4.0 s after
   * the command.
   */
  private static final double PLAN_TIME = 3.4;

  private final Vec3 start;
  private final Vec3 goal;
  private final Setpoint.Heading heading;
  private final Vec3 axis;
  private double time = -DroneSpec.TURN_DELAY;
  private double turned;

  /**
   * Creates a flip.
   *
   * @param start the drone's position, in the room frame [m]
   * @param heading the direction of the nose [rad]
   * @param direction a horizontal unit vector in the level body frame
   * @param miss the error of the end position, in the room frame [m]
   */
  Flip(Vec3 start, double heading, Vec3 direction, Vec3 miss) {
    this.start = start;
    this.goal = start.plusScaled(direction.turned(heading), ADVANCE).plus(miss);
    this.heading = new Setpoint.Heading(heading, 0);
    this.axis = Vec3.UP.cross(direction);
  }

  @Override
  public Setpoint advance(Sensed sensed, double seconds) {
    time += seconds;
    if (time < JUMP_TIME) {
      return jump(Math.max(0, time));
    }
    turned += turningRate(sensed.motion()) * seconds;
    if (looping()) {
      return new Setpoint.Spin(axis.times(DroneSpec.FLIP_RATE), LOOP_THRUST);
    }
    return new Setpoint.Track(goal, Vec3.ZERO, Vec3.ZERO, heading);
  }

  private Setpoint jump(double seconds) {
    double acceleration = seconds == 0 ? 0 : JUMP_ACCELERATION;
    double way = acceleration * seconds * seconds / 2;
    return new Setpoint.Track(
        start.plusScaled(Vec3.UP, way),
        Vec3.UP.times(acceleration * seconds),
        Vec3.UP.times(acceleration),
        heading);
  }

  private double turningRate(Motion motion) {
    return looping() ? motion.rate().dot(axis) : 0;
  }

  private boolean looping() {
    return time >= JUMP_TIME && turned < 2 * Math.PI - CATCH_ANGLE;
  }

  @Override
  public boolean planned() {
    return time >= PLAN_TIME;
  }

  @Override
  public Phrase progress() {
    return Phrase.of("%.0f of %.0f degrees turned", StrictMath.toDegrees(turned), 360.0);
  }

  @Override
  public boolean steerable() {
    return time < 0 || (time >= JUMP_TIME && !looping());
  }

  @Override
  public boolean leavesHoverHeights() {
    return true;
  }
}
