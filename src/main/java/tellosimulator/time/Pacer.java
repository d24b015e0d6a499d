package tellosimulator.time;

import java.util.OptionalDouble;
import java.util.concurrent.locks.LockSupport;
import java.util.function.LongSupplier;
import java.util.function.Supplier;

/**
 * Decides when the next step may run: either by the wall clock, or as fast as the machine allows.
 *
 * <p>Confined to the simulation thread, but any thread may end {@link #await} early with {@link
 * LockSupport#unpark}.
 */
public final class Pacer {

  /** Maximum lateness that is made up for [ns]. Any excess is lost and reported. Assumed. */
  private static final long CATCH_UP_NANOS = 250_000_000;

  /**
   * Maximum time for which the pacer waits for the next command at unlimited speed, while something
   * moves but no client waits [ns]. Decided: long compared with the computing time of a program
   * between two commands, but short for a person watching.
   */
  private static final long PATIENCE_NANOS = 2_000_000_000;

  /**
   * Maximum part of {@link #PATIENCE_NANOS} that a single wait can use up, even if it takes longer
   * because the process is suspended [ns].
   */
  private static final long PATIENCE_SLICE_NANOS = 50_000_000;

  /**
   * Minimum loss that is reported [simulated s]. Decided: a start on a busy machine loses about
   * this much.
   */
  private static final double WORTH_TELLING = 1;

  /**
   * Minimum time between reports of losses [ns]. Decided: long enough that reports do not fill a
   * log.
   */
  private static final long TELLING_NANOS = 60_000_000_000L;

  private final LongSupplier clock;
  private TimeFactor factor;
  private boolean paused;
  private long dueNanos;
  private long patienceNanos = PATIENCE_NANOS;
  private boolean waiting;
  private double lostSeconds;
  private double toldSeconds;
  private long toldNanos;

  public Pacer(TimeFactor factor) {
    this(factor, System::nanoTime);
  }

  /**
   * Creates a pacer with a given clock.
   *
   * @param clock a wall clock [ns], of which only differences are used
   */
  Pacer(TimeFactor factor, LongSupplier clock) {
    this.clock = clock;
    this.factor = factor;
    this.dueNanos = clock.getAsLong();
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
    dueNanos = clock.getAsLong();
  }

  /** Pauses time, or resumes it from the current moment. */
  public void setPaused(boolean newPaused) {
    paused = newPaused;
    dueNanos = clock.getAsLong();
  }

  /**
   * Returns whether a step may run now, and counts it as run.
   *
   * @param demand supplies the reason why time must pass; evaluated only at unlimited speed. For a
   *     pending reply, time passes at once. For mere motion, the pacer first waits up to two
   *     seconds for the next command; time during which the process is suspended does not count
   */
  public boolean stepDue(Supplier<PendingWork> demand) {
    if (paused) {
      return false;
    }
    if (factor.unlimited()) {
      return demanded(demand.get());
    }
    long late = clock.getAsLong() - dueNanos;
    if (late < 0) {
      return false;
    }
    long period = Math.round(SimTime.STEP_NANOS / factor.value());
    if (late > CATCH_UP_NANOS) {
      lose(late - period);
    }
    dueNanos += period;
    return true;
  }

  private void lose(long nanos) {
    dueNanos += nanos;
    lostSeconds += nanos * 1e-9 * factor.value();
  }

  /**
   * Returns the simulated time skipped since the start because the machine was too slow [simulated
   * s].
   */
  public double lostSeconds() {
    return lostSeconds;
  }

  /** Discards all losses so far, because they had no effect on a flight. */
  public void forgiveLoss() {
    lostSeconds = 0;
    toldSeconds = 0;
  }

  /**
   * Returns the loss to report now. There is none if the loss is less than a second, or if the last
   * report was less than a minute ago.
   *
   * @return the time lost since the last report [simulated s]; empty if there is nothing to report
   */
  public OptionalDouble lossToTell() {
    if (lostSeconds - toldSeconds < WORTH_TELLING) {
      return OptionalDouble.empty();
    }
    long now = clock.getAsLong();
    if (toldSeconds > 0 && now - toldNanos < TELLING_NANOS) {
      return OptionalDouble.empty();
    }
    double loss = lostSeconds - toldSeconds;
    toldSeconds = lostSeconds;
    toldNanos = now;
    return OptionalDouble.of(loss);
  }

  private boolean demanded(PendingWork demand) {
    waiting = demand == PendingWork.MOTION && patienceNanos > 0;
    if (demand != PendingWork.MOTION) {
      patienceNanos = PATIENCE_NANOS;
    }
    return demand != PendingWork.NONE && !waiting;
  }

  /** Blocks until a step is due by the wall clock, or the thread is unparked. */
  public void await() {
    if (factor.unlimited() && !paused && waiting) {
      awaitCommand();
      return;
    }
    if (paused || factor.unlimited()) {
      LockSupport.park(this);
      return;
    }
    long wait = dueNanos - clock.getAsLong();
    if (wait > 0) {
      LockSupport.parkNanos(this, wait);
    }
  }

  private void awaitCommand() {
    long before = clock.getAsLong();
    LockSupport.parkNanos(this, PATIENCE_SLICE_NANOS);
    patienceNanos -= Math.min(PATIENCE_SLICE_NANOS, clock.getAsLong() - before);
  }
}
