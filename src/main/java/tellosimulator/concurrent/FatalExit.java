package tellosimulator.concurrent;

import java.nio.charset.StandardCharsets;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.IntConsumer;
import org.slf4j.LoggerFactory;

/**
 * Ends the program with a message and a distinct exit code when an uncaught error is fatal, that
 * is, when memory is exhausted or a worker cannot continue. All required resources are allocated in
 * advance. Thread-safe.
 */
public final class FatalExit implements Thread.UncaughtExceptionHandler {

  /**
   * Exit code of the program after a fatal error. Documented: EX_SOFTWARE of sysexits.h, which
   * means an error in the program.
   */
  public static final int CODE = 70;

  /** Maximum time for closing files and sockets during the exit [ns]. Decided. */
  private static final long PATIENCE_NANOS = 5_000_000_000L;

  private static final byte[] OUT_OF_MEMORY =
      line(
          "The simulator ends, because its memory is full. Give it more, such as "
              + MemoryAdvice.COMMAND
              + ".");
  private static final byte[] BROKEN =
      line(
          "The simulator ends because of an error from which it cannot recover; please report it.");

  private final StandardError standardError = new StandardError();
  private final AtomicBoolean ending = new AtomicBoolean();
  private final Runnable deadline;
  private final IntConsumer exit;
  private final IntConsumer halt;

  /**
   * Creates a handler without installing it.
   *
   * @param deadline called when the exit begins
   * @param exit ends the process in an orderly way, with an exit code
   * @param halt ends the process immediately with an exit code, and needs no resources
   */
  FatalExit(Runnable deadline, IntConsumer exit, IntConsumer halt) {
    this.deadline = deadline;
    this.exit = exit;
    this.halt = halt;
  }

  /**
   * Installs a handler that ends the process when memory is exhausted or a worker cannot continue.
   *
   * @param flush writes buffered output; may fail
   */
  public static FatalExit install(Runnable flush) {
    // loads the class now, because no class can be loaded once memory is exhausted
    Exceptions.isFatal(new StackOverflowError());
    ExitDeadline deadline = new ExitDeadline(CODE, PATIENCE_NANOS);
    FatalExit installed =
        new FatalExit(deadline::begin, code -> exit(flush, code), Runtime.getRuntime()::halt);
    Thread.setDefaultUncaughtExceptionHandler(installed);
    return installed;
  }

  @Override
  public void uncaughtException(Thread thread, Throwable failure) {
    try {
      if (Worker.owns(thread) || Exceptions.isFatal(failure)) {
        end(thread, failure);
      } else if (!shuttingDown()) { // toolkit threads may fail during the shutdown
        LoggerFactory.getLogger(FatalExit.class).error("Unexpected, please report it", failure);
      }
    } catch (Throwable another) { // not even enough memory for the exit
      standardError.write(OUT_OF_MEMORY);
      halt.accept(CODE);
    }
  }

  /**
   * Returns whether the JVM is shutting down. Only then does it refuse to remove a shutdown hook.
   */
  private static boolean shuttingDown() {
    try {
      Runtime.getRuntime().removeShutdownHook(Thread.currentThread());
      return false;
    } catch (IllegalStateException ending) {
      return true;
    }
  }

  /** Ends the process, unless another thread is already ending it. */
  public void end(Thread thread, Throwable failure) {
    if (!ending.compareAndSet(false, true)) {
      return;
    }
    deadline.run();
    standardError.write(sentence(thread, failure));
    exit.accept(CODE);
  }

  private static void exit(Runnable flush, int code) {
    try {
      flush.run();
    } catch (Throwable another) {
      // the exit is more important than this failure
    }
    System.exit(code);
  }

  private static byte[] sentence(Thread thread, Throwable failure) {
    if (failure instanceof OutOfMemoryError) {
      return OUT_OF_MEMORY;
    }
    try {
      return line(
          "The simulator ends because of an error from which it cannot recover; please report this: "
              + thread.getName()
              + ", "
              + failure.toString().replaceAll("\\p{C}", "?"));
    } catch (Throwable another) {
      return BROKEN;
    }
  }

  private static byte[] line(String text) {
    return (text + System.lineSeparator()).getBytes(StandardCharsets.UTF_8);
  }
}
