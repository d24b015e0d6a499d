package tellosimulator.time;

import java.util.function.DoubleSupplier;

/**
 * A periodic event in simulated time. Not thread-safe.
 *
 * <p>Each due time is computed from the previous one, so the mean period does not depend on the
 * length of a step.
 */
public final class Periodic {

  private final DoubleSupplier period;
  private long dueNanos;

  /**
   * Creates a periodic event.
   *
   * @param start the first time
   * @param period supplies the time from each event to the next one [s]; must be positive
   */
  public Periodic(SimTime start, DoubleSupplier period) {
    this.dueNanos = start.nanos();
    this.period = period;
  }

  /**
   * Returns whether the event is due at {@code now}. If so, counts the event as done. Called once
   * per step.
   */
  public boolean due(SimTime now) {
    if (now.nanos() < dueNanos) {
      return false;
    }
    dueNanos += Math.round(period.getAsDouble() * 1e9);
    return true;
  }
}
