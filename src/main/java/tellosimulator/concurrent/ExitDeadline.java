package tellosimulator.concurrent;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.locks.LockSupport;

/**
 * Ends the process where ending it in order takes too long, as when a terminal takes no more text.
 * Needs no memory once it is made. For any thread.
 */
final class ExitDeadline {

  private final CountDownLatch begun = new CountDownLatch(1);

  /**
   * Waits for {@link #begin}.
   *
   * @param code the exit code
   * @param nanos how long the end may take [ns]
   */
  ExitDeadline(int code, long nanos) {
    Worker.once(
        "exit-deadline",
        ErrorPolicy.finish("The end in time is not sure"),
        () -> await(code, nanos));
  }

  /** Lets the time run. */
  void begin() {
    begun.countDown();
  }

  private void await(int code, long nanos) {
    try {
      begun.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return;
    }
    long begin = System.nanoTime();
    while (System.nanoTime() - begin < nanos) {
      LockSupport.parkNanos(nanos);
    }
    Runtime.getRuntime().halt(code);
  }
}
