package tellosimulator.command;

/**
 * Which mission pad a command means.
 *
 * @param id 1 to 8; -1 for the first pad that the drone identifies, -2 for the nearest one.
 *     Documented: SDK 3.0 User Guide
 */
public record PadChoice(int id) {

  /** As on the wire. */
  public String word() {
    return "m" + id;
  }
}
