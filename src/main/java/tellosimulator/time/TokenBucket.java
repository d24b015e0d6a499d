package tellosimulator.time;

/**
 * A token bucket by the wall clock: it lets a burst pass, and a steady rate after it. Not safe for
 * several threads at once.
 */
public final class TokenBucket {

  private final double perNano;
  private final double capacity;
  private double tokens;
  private long lastNanos;

  /**
   * A full bucket.
   *
   * @param perSecond tokens that come back [1/s]
   * @param burst tokens that it holds at the most
   */
  public TokenBucket(double perSecond, double burst) {
    this(perSecond, burst, System.nanoTime());
  }

  TokenBucket(double perSecond, double burst, long nanos) {
    this.perNano = perSecond / 1e9;
    this.capacity = burst;
    this.tokens = burst;
    this.lastNanos = nanos;
  }

  /** Takes a token, if there is one. */
  public boolean tryTake() {
    return tryTake(System.nanoTime());
  }

  boolean tryTake(long nanos) {
    tokens = Math.min(capacity, tokens + (nanos - lastNanos) * perNano);
    lastNanos = nanos;
    if (tokens < 1) {
      return false;
    }
    tokens--;
    return true;
  }
}
