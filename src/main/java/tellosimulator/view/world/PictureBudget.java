package tellosimulator.view.world;

/**
 * Says when the next picture of the inset may be taken: a limited number a second, and never more
 * than a fourth of the time spent on them. For one thread.
 */
final class PictureBudget {

  /** Shortest time from picture to picture [ns]. Decided: 10 a second. */
  static final long SHORTEST = 100_000_000;

  /** Of this many parts of the time, pictures take one. Decided. */
  static final long PARTS = 4;

  private long next = Long.MIN_VALUE;

  /** Whether a picture may be taken at a moment [ns]. */
  boolean allows(long nanos) {
    return nanos >= next;
  }

  /**
   * A picture was taken.
   *
   * @param nanos when it was begun [ns]
   * @param duration how long it took [ns]
   */
  void taken(long nanos, long duration) {
    next = nanos + Math.max(SHORTEST, PARTS * duration);
  }
}
