package tellosimulator.command;

/**
 * A text that the drone sends back, exactly as it goes out on the wire.
 *
 * @param text one character a byte (ISO-8859-1)
 */
public record Reply(String text) {

  /** Success, two bytes, no line end. Measured: ctello issue 7, Multi-Tello-Formation issue 5. */
  public static final Reply OK = new Reply("ok");

  /** General refusal. Documented: SDK 1.3 to 3.0. */
  public static final Reply ERROR = new Reply("error");

  /** Another command is still running. Report: FHNW 2020. */
  public static final Reply NOT_JOYSTICK = new Reply("error Not joystick");

  /** The command needs running motors. Report: FHNW 2020. */
  public static final Reply MOTOR_STOP = new Reply("error Motor stop");

  /** It does not know where it is. Measured: DJITelloPy 42, 57, 76, 133, 196, 208, 216. */
  public static final Reply NO_VALID_IMU = new Reply("error No valid imu");

  /** It is too hot for a takeoff. Documented: RoboMaster SDK, which knows this reply. */
  public static final Reply HIGH_TEMPERATURE = new Reply("error, high temp");

  /** A landing cut the command off. Measured: oh-tello, acceptance test B7. */
  public static final Reply AUTO_LAND = new Reply("error Auto land");

  /** The mission pad is not seen. Measured: tello-asyncio issue 4. */
  public static final Reply NO_VALID_MARKER = new Reply("error No valid marker");

  /** A mission pad was lost on the way. Measured: Tello-Python issue 88. */
  public static final Reply RUN_TIMEOUT = new Reply("error Run timeout");

  /** No such circle, too large or too small. Report: FHNW 2020. */
  public static final Reply RADIUS = new Reply("error Radius is too large!");

  /** A parameter is outside its range. Report: FHNW 2020. */
  public static final Reply OUT_OF_RANGE = new Reply("out of range");

  /** Second answer to {@code stop}. Report: FHNW 2020; Measured: tello-asyncio issue 13. */
  public static final Reply FORCED_STOP = new Reply("forced stop");

  /** The drone restarts. Measured: jtS3Helper notes; no blank after the comma. */
  public static final Reply WILL_REBOOT = new Reply("OK,drone will reboot in 3s");

  /** What precedes the echo of an unknown command. Report: FHNW 2020. */
  private static final String UNKNOWN = "unknown command: ";

  /** Numeric reads end with it. Report: FHNW 2020. */
  private static final String LINE_END = "\r\n";

  /** Whether a text is what a drone answers to an unknown command. */
  static boolean isEcho(String text) {
    return text.startsWith(UNKNOWN);
  }

  /** The reply to something that is no command. */
  public static Reply unknown(String echo) {
    return new Reply(UNKNOWN + echo);
  }

  /** The reply to a read: the value and a line end. */
  public static Reply line(String value) {
    return new Reply(value + LINE_END);
  }
}
