package tellosimulator.time;

import java.util.function.LongSupplier;

/** A token bucket: it admits a burst, and then a steady rate. Not thread-safe. */
public final class TokenBucket {

  /** A monotonic clock [ns]. */
  public static final LongSupplier WALL_CLOCK = System::nanoTime;

  private final double perNano;
  private final double capacity;
  private final LongSupplier nanos;
  private double tokens;
  private long lastNanos;

  /**
   * Creates a full bucket that uses the wall clock.
   *
   * @param perSecond the refill rate [tokens/s]
   * @param burst the capacity [tokens]
   */
  public TokenBucket(double perSecond, double burst) {
    this(perSecond, burst, WALL_CLOCK);
  }

  /**
   * Creates a full bucket that uses a given clock.
   *
   * @param perSecond the refill rate [tokens/s]
   * @param burst the capacity [tokens]
   * @param nanos a monotonic clock [ns]
   */
  public TokenBucket(double perSecond, double burst, LongSupplier nanos) {
    this.perNano = perSecond / 1e9;
    this.capacity = burst;
    this.nanos = nanos;
    this.tokens = burst;
    this.lastNanos = nanos.getAsLong();
  }

  /** Takes a token if there is one; returns whether there was one. */
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
