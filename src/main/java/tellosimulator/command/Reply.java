package tellosimulator.command;

import tellosimulator.controller.RefusalKind;

/**
 * A reply of the drone, exactly as on the wire.
 *
 * @param text one character per byte (ISO-8859-1)
 */
public record Reply(String text) {

  /**
   * Success. Two bytes, without a line end. Measured: ctello issue 7, Multi-Tello-Formation issue
   * 5.
   */
  public static final Reply OK = new Reply("ok");

  /** General refusal. Documented: SDK 1.3 to 3.0. */
  public static final Reply ERROR = new Reply("error");

  /** Another command is still running. Report: FHNW 2020. */
  public static final Reply NOT_JOYSTICK = new Reply("error Not joystick");

  /** The command needs running motors. Report: FHNW 2020. */
  public static final Reply MOTOR_STOP = new Reply("error Motor stop");

  /** The drone has lost its position. Measured: DJITelloPy 42, 57, 76, 133, 196, 208, 216. */
  public static final Reply NO_VALID_IMU = new Reply("error No valid imu");

  /** The drone is too hot for a takeoff. Documented: RoboMaster SDK, which handles this reply. */
  public static final Reply HIGH_TEMPERATURE = new Reply("error, high temp");

  /** A landing interrupted the command. Measured: oh-tello, acceptance test B7. */
  public static final Reply AUTO_LAND = new Reply("error Auto land");

  /** The mission pad is not in sight. Measured: tello-asyncio issue 4. */
  public static final Reply NO_VALID_MARKER = new Reply("error No valid marker");

  /** The mission pad was lost on the way. Measured: Tello-Python issue 88. */
  public static final Reply RUN_TIMEOUT = new Reply("error Run timeout");

  /**
   * The points of the curve define no circle, or the circle's radius is out of range. Report: FHNW
   * 2020.
   */
  public static final Reply RADIUS = new Reply("error Radius is too large!");

  /** A parameter is outside its range. Report: FHNW 2020. */
  public static final Reply OUT_OF_RANGE = new Reply("out of range");

  /** The second reply to {@code stop}. Report: FHNW 2020; Measured: tello-asyncio issue 13. */
  public static final Reply FORCED_STOP = new Reply("forced stop");

  /** The drone restarts. Measured: jtS3Helper notes; no space after the comma. */
  public static final Reply WILL_REBOOT = new Reply("OK,drone will reboot in 3s");

  /** Prefix of the echo of an unknown command. Report: FHNW 2020. */
  private static final String UNKNOWN = "unknown command: ";

  /** Suffix of the replies to most read commands. Report: FHNW 2020. */
  private static final String LINE_END = "\r\n";

  /** Returns the reply to an order that the drone has refused or could not complete. */
  static Reply of(RefusalKind kind) {
    return switch (kind) {
      case GENERAL -> ERROR;
      case BUSY -> NOT_JOYSTICK;
      case MOTORS_OFF -> MOTOR_STOP;
      case POSITION_UNKNOWN -> NO_VALID_IMU;
      case OVERHEATED -> HIGH_TEMPERATURE;
      case LANDING -> AUTO_LAND;
      case PAD_NOT_SEEN -> NO_VALID_MARKER;
      case PAD_LOST -> RUN_TIMEOUT;
      case RADIUS -> RADIUS;
    };
  }

  /** Whether a text is a drone's reply to an unknown command. */
  static boolean isEcho(String text) {
    return text.startsWith(UNKNOWN);
  }

  /** Returns the reply to a text that is not a command. */
  public static Reply unknown(String echo) {
    return new Reply(UNKNOWN + echo);
  }

  /** Returns the reply to a read command: the value and a line end. */
  public static Reply line(String value) {
    return new Reply(value + LINE_END);
  }
}
