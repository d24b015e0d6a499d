package tellosimulator.time;

import java.util.concurrent.locks.LockSupport;

/**
 * Provides ticks at a fixed rate of the wall clock to a thread that waits for them. Makes up for at
 * most three consecutive missed ticks, for example after a short halt of the whole machine.
 *
 * <p>Not thread-safe, except for {@link #wake} and {@link #nanos}.
 */
public final class Ticker {

  /**
   * Maximum number of missed ticks that are made up for. Decided: a halt of a tenth of a second
   * then costs no frame at 30 frames per second.
   */
  private static final int MADE_UP = 3;

  private volatile Thread owner = Thread.currentThread();
  private volatile boolean woken;
  private long due = System.nanoTime();

  /** Returns the wall clock time [ns]. Only differences are meaningful. */
  public long nanos() {
    return System.nanoTime();
  }

  /** Makes the next tick due at once. */
  public void restart() {
    due = System.nanoTime();
  }

  /**
   * Waits for the next tick.
   *
   * @param period the time from this tick to the next one [ns]
   * @return whether the tick came; false if the thread was woken first
   */
  public boolean awaitTick(long period) {
    own();
    long now = System.nanoTime();
    due = Math.max(due, now - MADE_UP * period);
    while (!woken) {
      long wait = due - System.nanoTime();
      if (wait <= 0) {
        due += period;
        return true;
      }
      LockSupport.parkNanos(this, wait);
    }
    woken = false;
    return false;
  }

  /** Returns the time of the next tick [ns, on the clock of {@link #nanos}]. */
  public long due() {
    return due;
  }

  /**
   * Waits until a moment [ns, on the clock of {@link #nanos}], even if the thread is woken. Returns
   * early if the thread is interrupted.
   */
  public void pauseUntil(long moment) {
    for (long wait = moment - System.nanoTime(); wait > 0; wait = moment - System.nanoTime()) {
      LockSupport.parkNanos(this, wait);
      if (Thread.currentThread().isInterrupted()) {
        return;
      }
    }
  }

  /** Waits until the thread is woken. Returns at once if it has been woken since it last waited. */
  public void rest() {
    own();
    while (!woken && !Thread.currentThread().isInterrupted()) {
      LockSupport.park(this);
    }
    woken = false;
  }

  /** Ends the current call of {@link #rest} or {@link #awaitTick}, or else the next one. */
  public void wake() {
    woken = true;
    LockSupport.unpark(owner);
  }

  private void own() {
    owner = Thread.currentThread();
  }
}
