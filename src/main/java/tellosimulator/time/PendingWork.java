package tellosimulator.time;

/** The reasons why simulated time must pass, in ascending order of urgency. */
public enum PendingWork {

  /** Nothing would change. */
  NONE,

  /** Something moves without a command, and no client waits for it to end. */
  MOTION,

  /** A client waits for a reply, or a command still has effects. */
  REPLY;

  public PendingWork or(PendingWork other) {
    return compareTo(other) < 0 ? other : this;
  }
}
