package tellosimulator.time;

import java.util.function.DoubleSupplier;

/**
 * Something that happens again and again in simulated time. For one thread.
 *
 * <p>Due times are counted from due time to due time, so that the mean period does not depend on
 * the length of a step.
 */
public final class Periodic {

  private final DoubleSupplier period;
  private long dueNanos;

  /**
   * @param start when it happens for the first time
   * @param period asked after each time for the seconds to the next one; must be positive
   */
  public Periodic(SimTime start, DoubleSupplier period) {
    this.dueNanos = start.nanos();
    this.period = period;
  }

  /** Whether it is due at {@code now}; if so, it is counted as done. Asked once a step. */
  public boolean due(SimTime now) {
    if (now.nanos() < dueNanos) {
      return false;
    }
    dueNanos += Math.round(period.getAsDouble() * 1e9);
    return true;
  }
}
