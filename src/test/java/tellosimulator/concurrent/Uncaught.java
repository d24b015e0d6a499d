package tellosimulator.concurrent;

import java.lang.Thread.UncaughtExceptionHandler;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/** Handles uncaught exceptions of threads, like the program, until it is closed. */
public final class Uncaught implements AutoCloseable {

  private final UncaughtExceptionHandler before = Thread.getDefaultUncaughtExceptionHandler();
  private final CountDownLatch came = new CountDownLatch(1);
  private volatile Thread thread;
  private volatile Throwable failure;

  public Uncaught() {
    Thread.setDefaultUncaughtExceptionHandler(
        (where, what) -> {
          thread = where;
          failure = what;
          came.countDown();
        });
  }

  /** Waits for the first uncaught exception. */
  public Throwable await() throws InterruptedException {
    if (!came.await(20, TimeUnit.SECONDS)) {
      throw new AssertionError("nothing was left uncaught");
    }
    return failure;
  }

  /** The thread that threw it. */
  public Thread thread() {
    return thread;
  }

  @Override
  public void close() {
    Thread.setDefaultUncaughtExceptionHandler(before);
  }
}
