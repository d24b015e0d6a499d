package tellosimulator.concurrent;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.locks.LockSupport;

/**
 * Halts the process if an orderly exit takes too long, for example because a terminal no longer
 * accepts text. Allocates nothing after construction. Thread-safe.
 */
final class ExitDeadline {

  private final CountDownLatch begun = new CountDownLatch(1);

  /**
   * Starts a thread that waits for {@link #begin}.
   *
   * @param code the exit code
   * @param nanos the maximum duration of the exit [ns]
   */
  ExitDeadline(int code, long nanos) {
    Worker.once(
        "exit-deadline",
        ErrorPolicy.finish("The exit deadline could not be enforced"),
        () -> await(code, nanos));
  }

  /** Starts the countdown. */
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
