package tellosimulator.sim;

/**
 * The importance of an event to a reader of the log. The constants are in descending order of
 * importance.
 */
public enum Severity {
  /** The end of the flight: a crash. */
  ERROR,
  /** Something that needs attention, such as a refused command. */
  WARNING,
  /** Commands, replies, flight events, changes. */
  INFORMATION,
  /** Frequent commands: read commands and {@code rc}. */
  DETAIL
}
