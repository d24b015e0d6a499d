package tellosimulator.concurrent;

import java.nio.charset.StandardCharsets;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.IntConsumer;
import org.slf4j.LoggerFactory;

/**
 * Ends the program with a message and an exit code of its own after an uncaught fatal error: memory
 * is exhausted, or a worker cannot continue. Everything it needs is allocated in advance. For any
 * thread.
 */
public final class FatalExit implements Thread.UncaughtExceptionHandler {

  /** The program's exit code. Documented: EX_SOFTWARE of sysexits.h, an error in the program. */
  public static final int CODE = 70;

  /** How long files and sockets may take to be closed [ns]. Decided. */
  private static final long PATIENCE_NANOS = 5_000_000_000L;

  private static final byte[] OUT_OF_MEMORY =
      line(
          "The simulator ends, because its memory is full. Give it more, such as "
              + MemoryAdvice.COMMAND
              + ".");
  private static final byte[] BROKEN =
      line("The simulator ends after an error that it cannot go on from; please report this.");

  private final StandardError standardError = new StandardError();
  private final AtomicBoolean ending = new AtomicBoolean();
  private final Runnable deadline;
  private final IntConsumer exit;
  private final IntConsumer halt;

  /**
   * Does nothing yet.
   *
   * @param deadline is told that the end has begun
   * @param exit ends the process with an exit code
   * @param halt does so at once, and needs nothing for it
   */
  FatalExit(Runnable deadline, IntConsumer exit, IntConsumer halt) {
    this.deadline = deadline;
    this.exit = exit;
    this.halt = halt;
  }

  /**
   * Ends the process from now on when no memory is left or a worker cannot go on.
   *
   * @param flush writes what is still to be written; may fail
   */
  public static FatalExit install(Runnable flush) {
    // a class that is loaded only when memory is full cannot be loaded any more
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
      } else if (!shuttingDown()) { // or toolkits fail in threads that have not heard of the end
        LoggerFactory.getLogger(FatalExit.class).error("Unexpected, please report it", failure);
      }
    } catch (Throwable another) { // there is no memory even for the end
      standardError.write(OUT_OF_MEMORY);
      halt.accept(CODE);
    }
  }

  /** Whether the virtual machine ends: only then it refuses to forget a hook. */
  private static boolean shuttingDown() {
    try {
      Runtime.getRuntime().removeShutdownHook(Thread.currentThread());
      return false;
    } catch (IllegalStateException ending) {
      return true;
    }
  }

  /** Ends the process, unless another thread does so already. */
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
      // what matters is the end
    }
    System.exit(code);
  }

  private static byte[] sentence(Thread thread, Throwable failure) {
    if (failure instanceof OutOfMemoryError) {
      return OUT_OF_MEMORY;
    }
    try {
      return line(
          "The simulator ends after an error that it cannot go on from; please report this: "
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
