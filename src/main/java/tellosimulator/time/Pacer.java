package tellosimulator.time;

import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;

/**
 * Decides when the next step may run, by the wall clock or as fast as the machine can.
 *
 * <p>For the simulation thread only, but for {@link LockSupport#unpark}, with which any thread may
 * end {@link #await} early.
 */
public final class Pacer {

  /** Lateness that is caught up by hurrying; what is beyond is given up [ns]. Assumed. */
  private static final long CATCH_UP_NANOS = 250_000_000;

  private TimeFactor factor;
  private boolean paused;
  private long dueNanos;

  public Pacer(TimeFactor factor) {
    this.factor = factor;
    this.dueNanos = System.nanoTime();
  }

  public TimeFactor factor() {
    return factor;
  }

  public boolean paused() {
    return paused;
  }

  /** Changes the speed from now on. */
  public void setFactor(TimeFactor newFactor) {
    factor = newFactor;
    dueNanos = System.nanoTime();
  }

  /** Lets time stand still, or go on from here. */
  public void setPaused(boolean newPaused) {
    paused = newPaused;
    dueNanos = System.nanoTime();
  }

  /**
   * Whether a step may run now; if so, it is counted as run.
   *
   * @param busy whether the simulation needs time to pass; as fast as possible means: only then
   */
  public boolean stepDue(BooleanSupplier busy) {
    if (paused) {
      return false;
    }
    if (factor.unlimited()) {
      return busy.getAsBoolean();
    }
    long late = System.nanoTime() - dueNanos;
    if (late < 0) {
      return false;
    }
    long period = Math.round(SimTime.STEP_NANOS / factor.value());
    dueNanos += late > CATCH_UP_NANOS ? late : period;
    return true;
  }

  /** Blocks until a step is due by the wall clock, or until somebody unparks the thread. */
  public void await() {
    if (paused || factor.unlimited()) {
      LockSupport.park(this);
      return;
    }
    long wait = dueNanos - System.nanoTime();
    if (wait > 0) {
      LockSupport.parkNanos(this, wait);
    }
  }
}
