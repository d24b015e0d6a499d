package tellosimulator.time;

import java.util.OptionalDouble;
import java.util.concurrent.locks.LockSupport;
import java.util.function.LongSupplier;
import java.util.function.Supplier;

/**
 * Decides when the next step may run, by the wall clock or as fast as the machine can.
 *
 * <p>For the simulation thread only, but for {@link LockSupport#unpark}, with which any thread may
 * end {@link #await} early.
 */
public final class Pacer {

  /** Lateness that is caught up by hurrying; what is beyond is lost and told [ns]. Assumed. */
  private static final long CATCH_UP_NANOS = 250_000_000;

  /**
   * How long mere motion waits for the next command, as fast as possible [ns]. Decided: long beside
   * what a program thinks between two commands, short for a person who looks on.
   */
  private static final long PATIENCE_NANOS = 2_000_000_000;

  /** What one wait takes away from the patience at the most, however long it was [ns]. */
  private static final long PATIENCE_SLICE_NANOS = 50_000_000;

  /** Less than this is not told [simulated s]. Decided: a start on a busy machine loses as much. */
  private static final double WORTH_TELLING = 1;

  /** Losses are told no more often than this [ns]. Decided: so that no log is full of them. */
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
   * @param clock of the wall [ns]; only differences mean something
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

  /** Lets time stand still, or go on from here. */
  public void setPaused(boolean newPaused) {
    paused = newPaused;
    dueNanos = clock.getAsLong();
  }

  /**
   * Whether a step may run now; if so, it is counted as run.
   *
   * @param demand why the simulation needs time to pass, which counts as fast as possible only: for
   *     a debt time passes at once; mere motion waits for the next command first, for two seconds
   *     in which this process really ran
   */
  public boolean stepDue(Supplier<Demand> demand) {
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

  /** What has been given up since the start, because the machine was too slow [simulated s]. */
  public double lostSeconds() {
    return lostSeconds;
  }

  /** Counts what was given up until now as not lost: nothing of it mattered. */
  public void forgiveLoss() {
    lostSeconds = 0;
    toldSeconds = 0;
  }

  /**
   * What of it is to be told to people now: nothing if it is less than a second, or if they were
   * told less than a minute ago.
   *
   * @return what was lost since they were told the last time [simulated s]; empty if nothing was
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
