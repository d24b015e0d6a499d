package tellosimulator.model;

import tellosimulator.world.Collider;

/** The airframe's constants, the same in every profile and behaviour. */
public final class DroneSpec {

  /** Standard gravity [m/s²]. Documented: ISO 80000-3. */
  public static final double GRAVITY = 9.80665;

  /**
   * Height of the body [m] and radius around the propellers' circles [m]. Documented: 98 by 92.5 by
   * 41 mm between the motors, 3-inch propellers (Tello User Manual): (98 + 76) / 2 mm.
   */
  public static final Collider COLLIDER = new Collider(0.087, 0.041);

  /**
   * Linear drag [1/s] and quadratic drag [1/m] for each unit of mass. Documented: 9 degrees of tilt
   * give 4 m/s and 25 degrees give 8 m/s (Tello User Manual): g tan 9° = 4 a + 16 b, g tan 25° = 8
   * a + 64 b.
   */
  public static final double LINEAR_DRAG = 0.205;

  public static final double QUADRATIC_DRAG = 0.0458;

  /** Largest tilt in flight [rad]. Documented: 25 degrees in fast mode (Tello User Manual). */
  public static final double MAX_TILT = StrictMath.toRadians(25);

  /** Largest thrust for each unit of weight. Assumed: brushed motors of this size. */
  public static final double MAX_THRUST_RATIO = 2.2;

  /** Natural frequency of the tilt response [rad/s]. Assumed: tilt follows within 0.2 s. */
  public static final double TILT_FREQUENCY = 14;

  /** Natural frequency of the yaw response [rad/s]. Measured: 0.1 to 0.2 s. */
  public static final double YAW_FREQUENCY = 8;

  /** Damping of both. Assumed: hardly any overshoot. */
  public static final double DAMPING = 0.85;

  /** Largest angular acceleration [rad/s²]. Assumed: the rate of a flip within 0.1 s. */
  public static final double MAX_ANGULAR_ACCELERATION = 220;

  /** Turning rate of a flip [rad/s]. Assumed: three turns a second. */
  public static final double FLIP_RATE = 19;

  /** Turning rate of {@code cw} [rad/s]. Measured: 50 to 60 degrees a second. */
  public static final double TURN_RATE = StrictMath.toRadians(55);

  /** Angular acceleration of {@code cw} [rad/s²]. Assumed: full rate after 0.3 s. */
  public static final double TURN_ACCELERATION = 3.2;

  /** From a move's command to its first motion [s]. Measured: 0.35 to 0.45 s. */
  public static final double MOVE_DELAY = 0.35;

  /** From a turn's command to its first motion [s]. Measured: 0.1 to 0.2 s. */
  public static final double TURN_DELAY = 0.15;

  /** Acceleration of a move [m/s²]. Measured: pitch -8 degrees, and g tan 8° is 1.38. */
  public static final double ACCELERATION = 1.3;

  /** Braking of a move [m/s²]. Measured: pitch +4 degrees, and g tan 4° is 0.69. */
  public static final double BRAKING = 0.65;

  /** Braking when a move is cut off [m/s²]. Assumed: more than at a planned end. */
  public static final double HARD_BRAKING = 2;

  /**
   * Peak speed of a move over 1 m [m/s]; it grows with the root of the distance. Measured: 0.3 over
   * 0.5 m and up to 0.7 over 1 m; 3.6 s for {@code forward 100} ask for the lower half.
   */
  public static final double PEAK_SPEED_OVER_ONE_METER = 0.47;

  /** Speed of a landing from above {@link #SLOW_LANDING_HEIGHT} [m/s]. Measured: 0.6. */
  public static final double LANDING_SPEED = 0.6;

  /** Speed of the last part of a landing [m/s]. Measured: 0.4. */
  public static final double SLOW_LANDING_SPEED = 0.4;

  /** Height at which a landing slows down [m]. Measured: about 60 cm. */
  public static final double SLOW_LANDING_HEIGHT = 0.6;

  /** From {@code takeoff} to leaving the floor [s]. Measured: 0.75. */
  public static final double LIFT_OFF_DELAY = 0.75;

  /** Greatest height above the floor [m]. Documented: the app's default limit. */
  public static final double MAX_HEIGHT = 10;

  /**
   * Above this speed a touch is a crash, unless a scenario says otherwise [m/s]. Observed: behind
   * propeller guards quadrotors bounce off a wall at low speed and flip over at a higher one
   * (betaflight issue 1972; Parallax, "What Propeller Guards Can Do"); nobody has published the
   * speed for a Tello. Derived: the rim of the guards is 15 mm above the centre of mass, so a hit
   * with a restitution of 0.5 starts a rotation of 1.5 · 0.015 / 0.035² = 18 rad/s for each m/s
   * (radius of gyration 35 mm). {@link #MAX_ANGULAR_ACCELERATION} stops that of 1.35 m/s at 24.8² /
   * (2 · 220) = 1.4 rad; a faster hit lays the drone on its side.
   */
  public static final double CRASH_SPEED = 1.35;

  /**
   * A fall with stopped motors from up to here does no harm [m]. Decided: nothing turns that could
   * be caught. Measured: after {@code emergency} at 2.9 m/s a drone flew again (oh-tello B15).
   */
  public static final double HARMLESS_FALL = 1.3;

  /**
   * Field of view of the cameras from left to right [rad], and how high a picture is for its width.
   * Measured: 55 degrees, 960 by 720 (calibrated pictures of several drones). Assumed: the same for
   * the camera in the underside, whose longer edge lies along the nose.
   */
  public static final double CAMERA_FIELD_OF_VIEW = StrictMath.toRadians(55);

  public static final double CAMERA_HEIGHT_SHARE = 0.75;

  /**
   * How far the camera in the nose looks down [rad]. Measured: about 15 degrees, the only concrete
   * figure, from a model of the drone for another simulator; other sources assume 0.
   */
  public static final double CAMERA_TILT = StrictMath.toRadians(15);

  /** How long a full battery flies [s]. Documented: 13 minutes (Tello User Manual). */
  public static final double ENDURANCE = 13 * 60;

  /** How long a full battery lasts on the ground [s]. Assumed: 2 percent a minute. */
  public static final double IDLE_ENDURANCE = 50 * 60;

  /** Speed of moves until {@code speed} says otherwise [m/s]. Report: {@code 100.0}. */
  public static final double DEFAULT_SPEED = 1;

  private DroneSpec() {}
}
