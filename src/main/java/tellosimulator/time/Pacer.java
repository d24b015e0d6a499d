package tellosimulator.time;

import java.util.concurrent.locks.LockSupport;
import java.util.function.Supplier;

/**
 * Decides when the next step may run, by the wall clock or as fast as the machine can.
 *
 * <p>For the simulation thread only, but for {@link LockSupport#unpark}, with which any thread may
 * end {@link #await} early.
 */
public final class Pacer {

  /** Lateness that is caught up by hurrying; what is beyond is given up [ns]. Assumed. */
  private static final long CATCH_UP_NANOS = 250_000_000;

  /**
   * How long mere motion waits for the next command, as fast as possible [ns]. Decided: long beside
   * what a program thinks between two commands, short for a person who looks on.
   */
  private static final long PATIENCE_NANOS = 1_000_000_000;

  /** What one wait takes away from the patience at the most, however long it was [ns]. */
  private static final long PATIENCE_SLICE_NANOS = 50_000_000;

  private TimeFactor factor;
  private boolean paused;
  private long dueNanos;
  private long patienceNanos = PATIENCE_NANOS;
  private boolean waiting;

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
   * @param demand why the simulation needs time to pass, which counts as fast as possible only: for
   *     a debt time passes at once; mere motion waits for the next command first, for one second in
   *     which this process really ran
   */
  public boolean stepDue(Supplier<Demand> demand) {
    if (paused) {
      return false;
    }
    if (factor.unlimited()) {
      return demanded(demand.get());
    }
    long late = System.nanoTime() - dueNanos;
    if (late < 0) {
      return false;
    }
    long period = Math.round(SimTime.STEP_NANOS / factor.value());
    dueNanos += late > CATCH_UP_NANOS ? late : period;
    return true;
  }

  private boolean demanded(Demand demand) {
    waiting = demand == Demand.MOTION && patienceNanos > 0;
    if (demand != Demand.MOTION) {
      patienceNanos = PATIENCE_NANOS;
    }
    return demand != Demand.NONE && !waiting;
  }

  /** Blocks until a step is due by the wall clock, or until somebody unparks the thread. */
  public void await() {
    if (factor.unlimited() && !paused && waiting) {
      awaitCommand();
      return;
    }
    if (paused || factor.unlimited()) {
      LockSupport.park(this);
      return;
    }
    long wait = dueNanos - System.nanoTime();
    if (wait > 0) {
      LockSupport.parkNanos(this, wait);
    }
  }

  private void awaitCommand() {
    long before = System.nanoTime();
    LockSupport.parkNanos(this, PATIENCE_SLICE_NANOS);
    patienceNanos -= Math.min(PATIENCE_SLICE_NANOS, System.nanoTime() - before);
  }
}
