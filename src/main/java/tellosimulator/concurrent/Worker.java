package tellosimulator.concurrent;

import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Repeats an agent's work on a thread of its own until it is ended, in the manner of Agrona's agent
 * runner. Whatever the work throws is told in one sentence and then lies behind; a worker that
 * fails too often gives its failure to the handler for uncaught exceptions, and those who wait for
 * it find that it has ended. Its thread never keeps the program alive. For any thread.
 */
public final class Worker implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(Worker.class);

  /**
   * Pause after a failure, so that work which fails again and again does not take a whole processor
   * [ns]. Decided.
   */
  private static final long BACK_OFF_NANOS = 10_000_000;

  /** Between two sentences about failures of the same worker [ns]. Decided. */
  private static final long QUIET_NANOS = 1_000_000_000;

  /** What a failure adds to the leaky bucket; each piece of work that succeeds takes 1 away. */
  private static final int FAILURE = 10;

  /** What it adds where memory was full: then each try takes the processors for long, too. */
  private static final int MEMORY_FULL = 40;

  /** The bucket's size. Decided: 100 failures in a row, so at least a second. */
  private static final int LIMIT = 1000;

  /** How long {@link #close} waits [ms]. Decided: longer than a picture takes on a busy machine. */
  private static final long PATIENCE_MS = 10_000;

  private static final ErrorPolicy UNDECIDED =
      ErrorPolicy.retry("What a thread does on errors failed");
  private static final ErrorPolicy UNCLOSED =
      ErrorPolicy.finish("What a thread does at its end failed");

  private final Agent agent;
  private final Thread thread;
  private final CountDownLatch ended = new CountDownLatch(1);
  private volatile boolean closing;

  /** Null unless it failed too often; not wrapped, as there may be no memory for that. */
  private volatile Throwable failure;

  private int bucket;
  private boolean told;
  private long toldNanos;
  private long untold;

  /** Marks the threads without which the program is not whole. */
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
   * Starts at once.
   *
   * @param name of the thread
   */
  public static Worker start(String name, Agent agent) {
    Worker worker = new Worker(name, agent);
    worker.thread.start();
    return worker;
  }

  /**
   * Starts to do something once.
   *
   * @param name of the thread
   * @param failed what is said if the task fails
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

  /** Whether a thread is a worker's; what such a thread does not catch ends the program. */
  static boolean owns(Thread thread) {
    return thread instanceof WorkerThread;
  }

  /** Ends a parked {@link Agent#idle}, now or the next time. */
  public void wake() {
    LockSupport.unpark(thread);
  }

  /** Whether nothing is done any more. */
  public boolean hasEnded() {
    return ended.getCount() == 0;
  }

  /** What it could not go on from; for others than its own thread, once it has ended. */
  public Optional<Throwable> failure() {
    return Optional.ofNullable(failure);
  }

  /** Ends it after what it does now, and does not wait. */
  public void end() {
    closing = true;
    wake();
  }

  /** Ends it and waits until it has ended; not for ever, and not on its own thread. */
  @Override
  public void close() {
    if (!close(PATIENCE_MS)) {
      LOG.warn("The thread {} has not ended after {} ms", thread.getName(), PATIENCE_MS);
    }
  }

  /**
   * Ends it.
   *
   * @param patienceMs how long to wait for that [ms]
   * @return whether it has ended, or will as soon as this thread lets it
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
    } catch (Throwable thrown) { // errors too, or the thread would end in silence
      return survives(thrown);
    }
  }

  /** Makes nothing new: there may be no memory left. */
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
