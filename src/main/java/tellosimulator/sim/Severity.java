package tellosimulator.sim;

/** How much something that happened matters to people; the most important first. */
public enum Severity {
  /** The flight is over: a crash. */
  ERROR,
  /** Something went otherwise than was asked for. */
  WARNING,
  /** What one wants to read: commands, replies, flights, changes. */
  INFORMATION,
  /** What comes by the dozen: reads and {@code rc}. */
  DETAIL
}
