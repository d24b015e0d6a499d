package tellosimulator.model;

import tellosimulator.math.Vec3;
import tellosimulator.world.Collider;

/** The constants of the airframe. They are the same in every profile and behaviour. */
public final class DroneSpec {

  /** Standard gravity [m/s²]. Documented: ISO 80000-3. */
  public static final double GRAVITY = 9.80665;

  /**
   * Radius of the circle around all propellers, and height of the body [m]. Documented: 98 by 92.5
   * mm between the motors, 41 mm high, 3-inch propellers (Tello User Manual). The radius is (98 +
   * 76) / 2 mm.
   */
  public static final Collider COLLIDER = new Collider(0.087, 0.041);

  /**
   * Linear drag per unit of mass [1/s]: the value a in the following equations. Documented: 9
   * degrees of tilt give 4 m/s and 25 degrees give 8 m/s (Tello User Manual), so g tan 9° = 4 a +
   * 16 b and g tan 25° = 8 a + 64 b.
   */
  public static final double LINEAR_DRAG = 0.205;

  /**
   * Quadratic drag per unit of mass [1/m]: the value b in the equations of {@link #LINEAR_DRAG}.
   */
  public static final double QUADRATIC_DRAG = 0.0458;

  /** Maximum tilt in flight [rad]. Documented: 25 degrees in fast mode (Tello User Manual). */
  public static final double MAX_TILT = StrictMath.toRadians(25);

  /** Maximum thrust-to-weight ratio. Assumed: typical of brushed motors of this size. */
  public static final double MAX_THRUST_RATIO = 2.2;

  /**
   * Natural frequency of the tilt response [rad/s]. Assumed: the tilt follows its target within 0.2
   * s.
   */
  public static final double TILT_FREQUENCY = 14;

  /**
   * Natural frequency of the yaw response [rad/s]. Measured: the yaw rate follows with a time
   * constant of 0.1 to 0.2 s.
   */
  public static final double YAW_FREQUENCY = 8;

  /**
   * Damping ratio of the tilt response and the yaw response. Assumed: there is hardly any
   * overshoot.
   */
  public static final double DAMPING = 0.85;

  /**
   * Maximum angular acceleration [rad/s²]. Assumed: the drone reaches the rate of a flip within 0.1
   * s.
   */
  public static final double MAX_ANGULAR_ACCELERATION = 220;

  /** Angular rate of a flip [rad/s]. Assumed: three turns per second. */
  public static final double FLIP_RATE = 19;

  /** Angular rate of {@code cw} and {@code ccw} [rad/s]. Measured: 50 to 60 degrees per second. */
  public static final double TURN_RATE = StrictMath.toRadians(55);

  /**
   * Angular acceleration of {@code cw} and {@code ccw} [rad/s²]. Assumed: the drone reaches the
   * full rate after 0.3 s.
   */
  public static final double TURN_ACCELERATION = 3.2;

  /** Time from the command of a move to its first motion [s]. Measured: 0.35 to 0.45 s. */
  public static final double MOVE_DELAY = 0.35;

  /** Time from the command of a turn to its first motion [s]. Measured: 0.1 to 0.2 s. */
  public static final double TURN_DELAY = 0.15;

  /** Acceleration of a move [m/s²]. Measured: the pitch is -8 degrees, and g tan 8° = 1.38 m/s². */
  public static final double ACCELERATION = 1.3;

  /** Deceleration of a move [m/s²]. Measured: the pitch is +4 degrees, and g tan 4° = 0.69 m/s². */
  public static final double BRAKING = 0.65;

  /** Deceleration of an interrupted move [m/s²]. Assumed: stronger than at a planned end. */
  public static final double HARD_BRAKING = 2;

  /**
   * Peak speed of a move over 1 m [m/s]. The peak speed of other moves grows with the square root
   * of the distance. Measured: peak speeds of 0.3 m/s over 0.5 m, and up to 0.7 m/s over 1 m. The
   * duration of {@code forward 100}, 3.6 s, requires a value well below 0.7 m/s.
   */
  public static final double PEAK_SPEED_OVER_ONE_METER = 0.47;

  /** Landing speed above {@link #SLOW_LANDING_HEIGHT} [m/s]. Measured: 0.6 m/s. */
  public static final double LANDING_SPEED = 0.6;

  /** Landing speed below {@link #SLOW_LANDING_HEIGHT} [m/s]. Measured: 0.4 m/s. */
  public static final double SLOW_LANDING_SPEED = 0.4;

  /** Height at which a landing slows down [m]. Measured: about 60 cm. */
  public static final double SLOW_LANDING_HEIGHT = 0.6;

  /** Time from {@code takeoff} to lift-off [s]. Measured: 0.75 s. */
  public static final double LIFT_OFF_DELAY = 0.75;

  /** Maximum height above the floor [m]. Documented: the app's default limit. */
  public static final double MAX_HEIGHT = 10;

  /**
   * Speed above which a contact is a crash, unless a scenario sets another speed [m/s]. Observed:
   * with propeller guards, quadrotors bounce off a wall at low speed and flip over at higher speed
   * (betaflight issue 1972; Parallax, "What Propeller Guards Can Do"). No source gives the speed
   * for a Tello. Derived: the rim of the guards is 15 mm above the centre of mass, so a hit with a
   * coefficient of restitution of 0.5 starts a rotation of 1.5 · 0.015 / 0.035² = 18 rad/s per m/s
   * (radius of gyration 35 mm). {@link #MAX_ANGULAR_ACCELERATION} stops the rotation of a hit at
   * 1.35 m/s within 24.8² / (2 · 220) = 1.4 rad; after a faster hit, the drone tips onto its side.
   */
  public static final double CRASH_SPEED = 1.35;

  /**
   * Maximum height of a harmless fall with stopped motors [m]. Decided: a stopped propeller does
   * not catch on anything, so a fall does less harm than a collision in flight. Measured: a drone
   * that hit the ground at 2.9 m/s after {@code emergency} could fly again (oh-tello B15).
   */
  public static final double HARMLESS_FALL = 1.3;

  /**
   * Horizontal field of view of the cameras [rad]. Measured: 55 degrees (calibrated pictures of
   * several drones). Assumed: the downward camera has the same field of view, and the longer edge
   * of its picture lies along the nose.
   */
  public static final double CAMERA_FIELD_OF_VIEW = StrictMath.toRadians(55);

  /**
   * Ratio of the height of a frame to its width. Measured: 960 by 720 pixels (calibrated pictures
   * of several drones). Assumed: the downward camera has the same ratio.
   */
  public static final double CAMERA_HEIGHT_SHARE = 0.75;

  /**
   * Position of the forward camera, in the body frame [m]. Measured: 3.5 cm ahead of the middle
   * (from the same model as {@link #CAMERA_TILT}). The height is the height of the lens.
   */
  public static final Vec3 CAMERA_PLACE = new Vec3(0.035, 0, 0.0185);

  /**
   * Downward tilt of the forward camera [rad]. Measured: about 15 degrees, according to a model of
   * the drone for another simulator. This is the only specific figure; other sources assume 0.
   */
  public static final double CAMERA_TILT = StrictMath.toRadians(15);

  /** Time that a full battery lasts in flight [s]. Documented: 13 minutes (Tello User Manual). */
  public static final double ENDURANCE = 13 * 60;

  /** Time that a full battery lasts on the ground [s]. Assumed: 2 percent per minute. */
  public static final double IDLE_ENDURANCE = 50 * 60;

  /** Speed of moves until {@code speed} sets another value [m/s]. Report: {@code 100.0}. */
  public static final double DEFAULT_SPEED = 1;

  private DroneSpec() {}
}
