package tellosimulator.time;

import java.util.function.LongSupplier;

/**
 * A token bucket: it lets a burst pass, and a steady rate after it. Not safe for several threads at
 * once.
 */
public final class TokenBucket {

  /** Never goes back [ns]. */
  public static final LongSupplier WALL_CLOCK = System::nanoTime;

  private final double perNano;
  private final double capacity;
  private final LongSupplier nanos;
  private double tokens;
  private long lastNanos;

  /**
   * A full bucket, by the wall clock.
   *
   * @param perSecond tokens that come back [1/s]
   * @param burst tokens that it holds at the most
   */
  public TokenBucket(double perSecond, double burst) {
    this(perSecond, burst, WALL_CLOCK);
  }

  /**
   * A full bucket.
   *
   * @param perSecond tokens that come back [1/s]
   * @param burst tokens that it holds at the most
   * @param nanos a clock that never goes back [ns]
   */
  public TokenBucket(double perSecond, double burst, LongSupplier nanos) {
    this.perNano = perSecond / 1e9;
    this.capacity = burst;
    this.nanos = nanos;
    this.tokens = burst;
    this.lastNanos = nanos.getAsLong();
  }

  /** Takes a token, if there is one. */
  public boolean tryTake() {
    long now = nanos.getAsLong();
    tokens = Math.min(capacity, tokens + (now - lastNanos) * perNano);
    lastNanos = now;
    if (tokens < 1) {
      return false;
    }
    tokens--;
    return true;
  }
}
