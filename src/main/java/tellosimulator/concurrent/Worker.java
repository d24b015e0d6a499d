package tellosimulator.concurrent;

import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Repeats the work of an agent on a thread of its own until the worker is ended, like Agrona's
 * agent runner. Any exception is logged in one line, and the worker continues. A worker that fails
 * too often passes its failure to the handler for uncaught exceptions; callers that wait for the
 * worker are notified that it has ended. The thread never keeps the program alive. Thread-safe.
 */
public final class Worker implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(Worker.class);

  /**
   * Pause after a failure, so that work that fails repeatedly does not occupy a whole processor
   * [ns]. Decided.
   */
  private static final long BACK_OFF_NANOS = 10_000_000;

  /** Minimum time between two log messages about failures of the same worker [ns]. Decided. */
  private static final long QUIET_NANOS = 1_000_000_000;

  /** The amount that a failure adds to a leaky bucket. Each successful piece of work removes 1. */
  private static final int FAILURE = 10;

  /**
   * The amount that a failure adds when memory is exhausted. It is larger because each attempt then
   * also keeps the processors busy for a long time.
   */
  private static final int MEMORY_FULL = 40;

  /** The capacity of the bucket. Decided: 100 failures in a row, which take at least a second. */
  private static final int LIMIT = 1000;

  /**
   * Maximum time for which {@link #close} waits [ms]. Decided: longer than rendering a picture
   * takes on a busy machine.
   */
  private static final long PATIENCE_MS = 10_000;

  private static final ErrorPolicy UNDECIDED =
      ErrorPolicy.retry("The error handler of a thread failed");
  private static final ErrorPolicy UNCLOSED =
      ErrorPolicy.finish("What a thread does at its end failed");

  private final Agent agent;
  private final Thread thread;
  private final CountDownLatch ended = new CountDownLatch(1);
  private volatile boolean closing;

  /**
   * The failure from which the worker could not recover, or null. It is not wrapped in an {@code
   * Optional}, since there may be no memory for one.
   */
  private volatile Throwable failure;

  private int bucket;
  private boolean told;
  private long toldNanos;
  private long untold;

  /** A thread of a worker. The program cannot continue if an exception ends such a thread. */
  private static final class WorkerThread extends Thread {
    WorkerThread(Runnable work, String name) {
      super(work, name);
    }
  }

  private Worker(String name, Agent agent) {
    this.agent = agent;
    thread = new WorkerThread(this::run, name);
    thread.setDaemon(true);
  }

  /**
   * Starts a worker.
   *
   * @param name the name of the thread
   */
  public static Worker start(String name, Agent agent) {
    Worker worker = new Worker(name, agent);
    worker.thread.start();
    return worker;
  }

  /**
   * Starts a worker that runs a task once.
   *
   * @param name the name of the thread
   * @param failed the policy that applies if the task fails
   */
  public static Worker once(String name, ErrorPolicy failed, Runnable task) {
    return start(
        name,
        new Agent() {
          @Override
          public Outcome doWork() {
            task.run();
            return Outcome.FINISHED;
          }

          @Override
          public ErrorPolicy onError(Throwable failure) {
            return failed;
          }
        });
  }

  /**
   * Returns whether a thread belongs to a worker. An exception that such a thread does not catch
   * ends the program.
   */
  static boolean owns(Thread thread) {
    return thread instanceof WorkerThread;
  }

  /**
   * Wakes an agent that is parked in {@link Agent#idle}, or makes the next such call return
   * immediately.
   */
  public void wake() {
    LockSupport.unpark(thread);
  }

  /** Whether the worker has ended. */
  public boolean hasEnded() {
    return ended.getCount() == 0;
  }

  /**
   * Returns the failure from which the worker could not recover; empty if there is none. Other
   * threads see the failure once the worker has ended.
   */
  public Optional<Throwable> failure() {
    return Optional.ofNullable(failure);
  }

  /** Makes the worker end after the work in progress. Does not wait for the end. */
  public void end() {
    closing = true;
    wake();
  }

  /**
   * Ends the worker and waits until it has ended, but only for a limited time. Does not wait if
   * called on the worker's own thread.
   */
  @Override
  public void close() {
    if (!close(PATIENCE_MS)) {
      LOG.warn("The thread {} has not ended after {} ms", thread.getName(), PATIENCE_MS);
    }
  }

  /**
   * Ends the worker.
   *
   * @param patienceMs the maximum time to wait [ms]
   * @return false if the worker has not ended in time; true if it has ended, if the wait was
   *     interrupted, or if the call was made on the worker's own thread
   */
  boolean close(long patienceMs) {
    end();
    if (Thread.currentThread() == thread) {
      return true;
    }
    try {
      return ended.await(patienceMs, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return true;
    }
  }

  private void run() {
    boolean running = true;
    try {
      while (running && !closing) {
        running = turn();
      }
    } finally {
      conclude();
    }
    if (failure != null) {
      thread.getUncaughtExceptionHandler().uncaughtException(thread, failure);
    }
  }

  private boolean turn() {
    try {
      Agent.Outcome outcome = agent.doWork();
      if (outcome == Agent.Outcome.IDLE) {
        agent.idle();
      }
      bucket = Math.max(0, bucket - 1);
      return outcome != Agent.Outcome.FINISHED;
    } catch (Throwable thrown) { // errors as well, otherwise the thread would end silently
      return survives(thrown);
    }
  }

  /**
   * Returns whether the worker continues after a failure. Allocates nothing, since memory may be
   * exhausted.
   */
  private boolean survives(Throwable thrown) {
    ErrorPolicy policy = policy(thrown);
    tell(policy, thrown);
    if (policy.action() == ErrorPolicy.Action.FINISH) {
      return false;
    }
    if (policy.action() == ErrorPolicy.Action.RETRY) {
      bucket += thrown instanceof OutOfMemoryError ? MEMORY_FULL : FAILURE;
    }
    if (bucket >= LIMIT) {
      failure = thrown;
      return false;
    }
    if (!closing) {
      LockSupport.parkNanos(BACK_OFF_NANOS);
    }
    return true;
  }

  private ErrorPolicy policy(Throwable thrown) {
    try {
      return agent.onError(thrown);
    } catch (Throwable another) {
      return UNDECIDED;
    }
  }

  private void tell(ErrorPolicy policy, Throwable thrown) {
    long now = System.nanoTime();
    if (told && now - toldNanos < QUIET_NANOS) {
      untold++;
      return;
    }
    policy.tell(thrown, untold);
    told = true;
    toldNanos = now;
    untold = 0;
  }

  private void conclude() {
    try {
      agent.onClose();
    } catch (Throwable thrown) {
      UNCLOSED.tell(thrown);
    } finally {
      ended.countDown();
    }
  }
}
