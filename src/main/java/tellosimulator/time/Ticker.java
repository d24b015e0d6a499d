package tellosimulator.time;

import java.util.concurrent.locks.LockSupport;

/**
 * Ticks at a fixed rate of the wall clock, for a thread that waits on it. Of ticks that are missed
 * one after another no more than three are made up for, as after a short halt of the whole machine.
 *
 * <p>For one thread, but for {@link #wake} and {@link #nanos}, which are for any.
 */
public final class Ticker {

  /** Decided: so a halt of a tenth of a second costs nobody any of 30 pictures a second. */
  private static final int MADE_UP = 3;

  private volatile Thread owner = Thread.currentThread();
  private volatile boolean woken;
  private long due = System.nanoTime();

  /** The wall clock [ns]; only differences mean something. */
  public long nanos() {
    return System.nanoTime();
  }

  /** Lets the next tick come at once. */
  public void restart() {
    due = System.nanoTime();
  }

  /**
   * Waits for the next tick.
   *
   * @param period from this tick to the one after it [ns]
   * @return whether it came; false if somebody woke the thread before
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

  /** When the next tick is due [ns on {@link #nanos}]. */
  public long due() {
    return due;
  }

  /** Waits until a moment [ns on {@link #nanos}], whoever wakes the thread. */
  public void pauseUntil(long moment) {
    for (long wait = moment - System.nanoTime(); wait > 0; wait = moment - System.nanoTime()) {
      LockSupport.parkNanos(this, wait);
      if (Thread.currentThread().isInterrupted()) {
        return;
      }
    }
  }

  /**
   * Waits until somebody wakes the thread; not at all if that has happened since it last waited.
   */
  public void rest() {
    own();
    while (!woken && !Thread.currentThread().isInterrupted()) {
      LockSupport.park(this);
    }
    woken = false;
  }

  /** Ends {@link #rest} or {@link #awaitTick}, now or the next time. */
  public void wake() {
    woken = true;
    LockSupport.unpark(owner);
  }

  private void own() {
    owner = Thread.currentThread();
  }
}
