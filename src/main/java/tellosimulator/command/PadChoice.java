package tellosimulator.command;

/**
 * Which mission pad a command means.
 *
 * @param id 1 to 8; {@link #FIRST_SEEN} or {@link #NEAREST}
 */
public record PadChoice(int id) {

  /** {@code m-1}: the first pad that the drone identifies. Documented: SDK 3.0 User Guide. */
  public static final int FIRST_SEEN = -1;

  /** {@code m-2}: the nearest pad. Documented: SDK 3.0 User Guide. */
  public static final int NEAREST = -2;

  /** As on the wire. */
  public String word() {
    return "m" + id;
  }
}
