package tellosimulator.view.testing;

import static tellosimulator.view.testing.WindowFixture.onFxThread;

import java.lang.Thread.UncaughtExceptionHandler;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/** What the JavaFX thread throws and nobody catches, until it is closed. For a test's thread. */
public final class FxFailures implements AutoCloseable {

  private final BlockingQueue<Throwable> uncaught = new LinkedBlockingQueue<>();
  private final UncaughtExceptionHandler before;

  /** Listens from now on; the toolkit must run. */
  public FxFailures() {
    before = handle((thread, failure) -> uncaught.add(failure));
  }

  private static UncaughtExceptionHandler handle(UncaughtExceptionHandler handler) {
    return onFxThread(
        () -> {
          Thread thread = Thread.currentThread();
          UncaughtExceptionHandler previous = thread.getUncaughtExceptionHandler();
          thread.setUncaughtExceptionHandler(handler);
          return previous;
        });
  }

  /** Waits for the next one. */
  public Throwable next() throws InterruptedException {
    Throwable failure = uncaught.poll(60, TimeUnit.SECONDS);
    if (failure == null) {
      throw new AssertionError("nothing is thrown");
    }
    return failure;
  }

  @Override
  public void close() {
    handle(before);
    if (!uncaught.isEmpty()) {
      throw new AssertionError("thrown on the JavaFX thread: " + uncaught, uncaught.peek());
    }
  }
}
