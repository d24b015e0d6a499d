package tellosimulator.controller;

/**
 * The mission pad that a command refers to.
 *
 * @param id 1 to 8; -1 for the first pad that the drone identifies, -2 for the nearest one.
 *     Documented: SDK 3.0 User Guide
 */
public record PadChoice(int id) {

  /** Returns the word on the wire. */
  public String word() {
    return "m" + id;
  }
}
