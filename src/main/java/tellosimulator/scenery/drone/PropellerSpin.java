package tellosimulator.scenery.drone;

import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.FlightPhase;
import tellosimulator.model.Motion;

/**
 * How a drone's propellers turn in the picture: slower than real ones, of which one would see
 * nothing but flicker. Speeds are relative to that of hovering. For one thread.
 */
public final class PropellerSpin {

  /** Speed while the motors idle. Assumed: by eye. */
  static final double IDLE = 0.25;

  /** From this speed on one sees a disc instead of blades. Decided: by eye. */
  static final double BLURRED = 0.55;

  /** Time constants of spinning up and of running down [s]. Assumed: by eye. */
  private static final double SPIN_UP = 0.2;

  private static final double RUN_DOWN = 0.45;

  /** Turning rate in the picture at hover [rad/s]. Decided: by eye. */
  private static final double SHOWN_RATE = 26;

  /**
   * Largest turn between two pictures [rad]. Decided: less than a quarter turn, from which on two
   * blades seem to turn backwards.
   */
  static final double LARGEST_TURN = Math.toRadians(50);

  private double speed;
  private double angle;

  /** Propellers that stand still. */
  public PropellerSpin() {}

  /**
   * Propellers that have turned like this for a long time. So a picture depends on nothing but its
   * moment.
   *
   * @param seconds on any clock
   */
  public static PropellerSpin steady(FlightPhase phase, Motion motion, double seconds) {
    PropellerSpin spin = new PropellerSpin();
    spin.speed = wanted(phase, motion);
    spin.angle = phase.motorsOn() ? SHOWN_RATE * seconds % (2 * Math.PI) : 0;
    return spin;
  }

  /** The speed that the motors of a drone strive for. */
  public static double wanted(FlightPhase phase, Motion motion) {
    if (!phase.motorsOn()) {
      return 0;
    }
    if (!phase.flying()) {
      return IDLE;
    }
    Vec3 up = motion.attitude().up();
    double thrustRatio = motion.acceleration().dot(up) / DroneSpec.GRAVITY;
    return Math.sqrt(Math.max(0.4, Math.min(DroneSpec.MAX_THRUST_RATIO, thrustRatio)));
  }

  /**
   * Lets time pass.
   *
   * @param wanted the speed to strive for
   * @param seconds since the last picture
   * @return whether something moved
   */
  public boolean advance(double wanted, double seconds) {
    if (speed == 0 && wanted == 0) {
      return false;
    }
    double constant = wanted > speed ? SPIN_UP : RUN_DOWN;
    speed += (wanted - speed) * (1 - StrictMath.exp(-seconds / constant));
    if (wanted == 0 && speed < 0.01) {
      speed = 0;
    }
    angle += Math.min(LARGEST_TURN, speed * SHOWN_RATE * seconds);
    angle %= 2 * Math.PI;
    return true;
  }

  double speed() {
    return speed;
  }

  /** How far the propellers have turned [rad], within a turn. */
  public double angle() {
    return angle;
  }

  public boolean blurred() {
    return speed >= BLURRED;
  }
}
