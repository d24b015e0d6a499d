package tellosimulator.time;

import java.util.concurrent.locks.LockSupport;

/** The one place where threads are started. */
public final class Threads {

  private Threads() {}

  /** Starts a daemon thread, which never keeps the program alive. */
  public static Thread start(String name, Runnable work) {
    Thread thread = new Thread(work, name);
    thread.setDaemon(true);
    thread.start();
    return thread;
  }

  /** Waits until a thread has ended, or until the waiting thread is interrupted. */
  public static void join(Thread thread) {
    try {
      thread.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /**
   * Waits a moment after a failure, so that a loop which fails again and again does not take a
   * whole processor.
   */
  public static void backOff() {
    LockSupport.parkNanos(10_000_000);
  }
}
