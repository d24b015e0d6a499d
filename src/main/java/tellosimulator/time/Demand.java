package tellosimulator.time;

/** Why simulated time must pass; in rising order. */
public enum Demand {

  /** Nothing would change. */
  NONE,

  /** Something moves on by itself, without an end that anybody waits for. */
  MOTION,

  /** Somebody waits for an answer, or what a command has caused is not over yet. */
  DEBT;

  public Demand or(Demand other) {
    return compareTo(other) < 0 ? other : this;
  }
}
