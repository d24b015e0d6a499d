package tellosimulator.goal;

/** A kind of mistake that can cost points. */
public enum Infraction {
  /** A drone touched something in flight, without a crash. */
  TOUCH,
  /** A drone crashed. */
  CRASH,
  /** A drone answered a command with an error: it refused the command or could not complete it. */
  REFUSED,
  /**
   * A drone came down in another way than by a command to land, without a crash, or was still in
   * the air at the end of the run.
   */
  NOT_LANDED
}
