package tellosimulator.concurrent;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tellosimulator.testing.CapturedLog;

@Timeout(value = 60, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
@Tag("slow")
class WorkerTest {

  private static final int ENDLESSLY = Integer.MAX_VALUE;

  private final CapturedLog log = CapturedLog.of(ErrorPolicy.class);

  @AfterEach
  void close() {
    log.close();
  }

  /** Throws in its first calls, and then waits until it is ended. */
  private static class Failing implements Agent {

    final AtomicInteger calls = new AtomicInteger();
    final AtomicInteger closed = new AtomicInteger();
    final CountDownLatch succeeded = new CountDownLatch(1);
    private final ErrorPolicy policy;
    private final Throwable failure;
    private final int failures;

    Failing(ErrorPolicy policy, Throwable failure, int failures) {
      this.policy = policy;
      this.failure = failure;
      this.failures = failures;
    }

    @Override
    public Outcome doWork() throws Exception {
      if (calls.incrementAndGet() > failures) {
        succeeded.countDown();
        return Outcome.IDLE;
      }
      if (failure instanceof Error error) {
        throw error;
      }
      throw (Exception) failure;
    }

    @Override
    public void idle() {
      LockSupport.park();
    }

    @Override
    public ErrorPolicy onError(Throwable thrown) {
      assertThat(thrown).isSameAs(failure);
      return policy;
    }

    @Override
    public void onClose() {
      closed.incrementAndGet();
    }
  }

  static List<Throwable> failures() {
    return List.of(
        new IllegalStateException("broken on purpose"),
        new IOException("broken on purpose"),
        new OutOfMemoryError("broken on purpose"),
        new StackOverflowError("broken on purpose"),
        new NoClassDefFoundError("broken/on/purpose"),
        new AssertionError("broken on purpose"));
  }

  @ParameterizedTest
  @MethodSource("failures")
  void goesOnAfterWhateverItsWorkThrows(Throwable failure) throws InterruptedException {
    for (ErrorPolicy policy :
        List.of(ErrorPolicy.goOn("Work failed"), ErrorPolicy.retry("Work failed"))) {
      Failing agent = new Failing(policy, failure, 2);
      try (Worker worker = Worker.start("fails twice", agent)) {
        assertThat(agent.succeeded.await(20, TimeUnit.SECONDS)).isTrue();
        assertThat(agent.calls).hasValueGreaterThanOrEqualTo(3);
        assertThat(worker.hasEnded()).isFalse();
        assertThat(worker.failure()).isEmpty();
        assertThat(log.next()).startsWith("Work failed");
        assertThat(log.isEmpty()).as("the second time is not told at once").isTrue();
      }
    }
  }

  @ParameterizedTest
  @MethodSource("failures")
  void whoFailsTooOftenEndsAndLeavesTheFailureUncaught(Throwable failure) throws Exception {
    Failing agent = new Failing(ErrorPolicy.retry("Work failed"), failure, ENDLESSLY);
    try (Uncaught uncaught = new Uncaught();
        Worker worker = Worker.start("fails always", agent)) {
      assertThat(uncaught.await()).isSameAs(failure);

      assertThat(uncaught.thread().getName()).isEqualTo("fails always");
      assertThat(Worker.owns(uncaught.thread())).isTrue();
      assertThat(worker.hasEnded()).as("before its failure is reported").isTrue();
      assertThat(worker.failure()).containsSame(failure);
      assertThat(agent.closed).hasValue(1);
      // 1000 / 10 and 1000 / 40: bucket size divided by the amount that a failure adds
      assertThat(agent.calls).hasValue(failure instanceof OutOfMemoryError ? 25 : 100);
      assertThat(log.next()).startsWith("Work failed");
    }
  }

  @Test
  void whoMayFailAsOftenAsItLikesGoesOn() throws InterruptedException {
    Failing agent = new Failing(ErrorPolicy.goOn("Work failed"), new OutOfMemoryError(), 110);
    try (Worker worker = Worker.start("fails often", agent)) {
      assertThat(agent.succeeded.await(20, TimeUnit.SECONDS)).isTrue();
      assertThat(worker.hasEnded()).isFalse();
    }
  }

  @Test
  void whatTheProgramDoesNotNeedEndsAlone() throws InterruptedException {
    CountDownLatch over = new CountDownLatch(1);
    Failing agent =
        new Failing(ErrorPolicy.finish("Work failed"), new OutOfMemoryError(), ENDLESSLY) {
          @Override
          public void onClose() {
            over.countDown();
          }
        };
    Worker worker = Worker.start("fails once", agent);
    assertThat(over.await(20, TimeUnit.SECONDS)).isTrue();
    worker.close();

    assertThat(worker.hasEnded()).isTrue();
    assertThat(worker.failure()).isEmpty();
    assertThat(agent.calls).hasValue(1);
  }

  @Test
  void anErrorWhileErrorsAreHandledDoesNotEndItInSilence() throws Exception {
    Error failure = new OutOfMemoryError("broken on purpose");
    Failing agent =
        new Failing(ErrorPolicy.goOn("Work failed"), failure, ENDLESSLY) {
          @Override
          public ErrorPolicy onError(Throwable thrown) {
            throw new OutOfMemoryError("broken once more");
          }

          @Override
          public void onClose() {
            throw new OutOfMemoryError("broken at the end");
          }
        };
    try (Uncaught uncaught = new Uncaught();
        Worker worker = Worker.start("broken all over", agent)) {
      assertThat(uncaught.await()).isSameAs(failure);
      assertThat(worker.hasEnded()).isTrue();
    }
  }

  @Test
  void idlesUntilItIsWoken() throws InterruptedException {
    BlockingQueue<String> done = new LinkedBlockingQueue<>();
    Agent agent =
        new Agent() {
          @Override
          public Outcome doWork() {
            done.add("work");
            return Outcome.IDLE;
          }

          @Override
          public void idle() {
            done.add("idle");
            LockSupport.park();
          }

          @Override
          public ErrorPolicy onError(Throwable failure) {
            return ErrorPolicy.goOn("Work failed");
          }
        };
    try (Worker worker = Worker.start("idle", agent)) {
      List<String> seen = new ArrayList<>();
      while (seen.size() < 6) {
        worker.wake();
        seen.add(done.take());
      }
      assertThat(seen).containsExactly("work", "idle", "work", "idle", "work", "idle");
    }
  }

  @Test
  void closingWaitsUntilItHasEnded() {
    Failing agent = new Failing(ErrorPolicy.goOn("Work failed"), new Exception(), 0);
    Worker worker = Worker.start("closed", agent);

    worker.close();

    assertThat(worker.hasEnded()).isTrue();
    assertThat(agent.closed).hasValue(1);
    worker.close();
  }

  @Test
  void closingDoesNotWaitForEver() throws InterruptedException {
    CountDownLatch unblocked = new CountDownLatch(1);
    CountDownLatch begun = new CountDownLatch(1);
    Agent agent =
        new Agent() {
          @Override
          public Outcome doWork() throws InterruptedException {
            begun.countDown();
            unblocked.await();
            return Outcome.WORKED;
          }

          @Override
          public ErrorPolicy onError(Throwable failure) {
            return ErrorPolicy.goOn("Work failed");
          }
        };
    Worker worker = Worker.start("blocked", agent);
    begun.await();

    assertThat(worker.close(20)).isFalse();
    assertThat(worker.hasEnded()).isFalse();

    unblocked.countDown();
    assertThat(worker.close(20_000)).isTrue();
    assertThat(worker.hasEnded()).isTrue();
  }

  @Test
  void closesItselfWithoutWaiting() throws InterruptedException {
    BlockingQueue<Worker> itself = new LinkedBlockingQueue<>();
    CountDownLatch ended = new CountDownLatch(1);
    Agent agent =
        new Agent() {
          @Override
          public Outcome doWork() throws InterruptedException {
            itself.take().close();
            return Outcome.WORKED;
          }

          @Override
          public ErrorPolicy onError(Throwable failure) {
            return ErrorPolicy.goOn("Work failed");
          }

          @Override
          public void onClose() {
            ended.countDown();
          }
        };
    try (Worker worker = Worker.start("closes itself", agent)) {
      itself.add(worker);
      assertThat(ended.await(20, TimeUnit.SECONDS)).isTrue();
    }
  }

  @Test
  void aTaskIsDoneOnceAndItsThreadIsADaemon() throws InterruptedException {
    BlockingQueue<Thread> threads = new LinkedBlockingQueue<>();
    Worker worker =
        Worker.once(
            "task", ErrorPolicy.finish("A task failed"), () -> threads.add(Thread.currentThread()));
    Thread thread = threads.take();
    worker.close();

    assertThat(threads).isEmpty();
    assertThat(thread.getName()).isEqualTo("task");
    assertThat(thread.isDaemon()).isTrue();
    assertThat(Worker.owns(Thread.currentThread())).isFalse();
  }
}
