package tellosimulator.concurrent;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tellosimulator.testing.CapturedLog;

@Timeout(value = 60, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class FatalExitTest {

  private final List<Object> happened = new ArrayList<>();
  private final FatalExit fatal =
      new FatalExit(
          () -> happened.add("deadline"), happened::add, code -> happened.add("halt " + code));

  @Test
  void withoutMemoryTheProgramEndsOnceWithACodeOfItsOwnAndADeadline() {
    fatal.uncaughtException(Thread.currentThread(), new OutOfMemoryError("broken on purpose"));
    fatal.uncaughtException(Thread.currentThread(), new OutOfMemoryError("broken on purpose"));

    assertThat(happened).containsExactly("deadline", 70);
  }

  @Test
  void whereEvenTheEndFailsForWantOfMemoryTheProcessIsHalted() {
    FatalExit starved =
        new FatalExit(
            () -> {
              throw new OutOfMemoryError("broken on purpose");
            },
            happened::add,
            code -> happened.add("halt " + code));

    starved.uncaughtException(Thread.currentThread(), new OutOfMemoryError("broken on purpose"));

    assertThat(happened).containsExactly("halt 70");
  }

  @Test
  void whatAnotherThreadDoesNotCatchIsLoggedAndEndsNothing() throws InterruptedException {
    try (CapturedLog log = CapturedLog.of(FatalExit.class)) {
      fatal.uncaughtException(Thread.currentThread(), new StackOverflowError());
      fatal.uncaughtException(Thread.currentThread(), new IllegalStateException("on purpose"));

      assertThat(log.next()).isEqualTo("Unexpected, please report it");
      assertThat(log.next()).isEqualTo("Unexpected, please report it");
    }
    assertThat(happened).isEmpty();
  }

  @Test
  void aWorkerThatCannotGoOnEndsTheProgramWhateverItsFailure() throws InterruptedException {
    CountDownLatch ended = new CountDownLatch(1);
    FatalExit ending = new FatalExit(() -> {}, code -> ended.countDown(), code -> {});
    Agent failing =
        new Agent() {
          @Override
          public Outcome doWork() {
            throw new IllegalStateException("broken on purpose");
          }

          @Override
          public ErrorPolicy onError(Throwable failure) {
            return ErrorPolicy.retry("Work failed");
          }
        };
    Thread.UncaughtExceptionHandler before = Thread.getDefaultUncaughtExceptionHandler();
    Thread.setDefaultUncaughtExceptionHandler(ending);
    try (CapturedLog log = CapturedLog.of(ErrorPolicy.class);
        Worker worker = Worker.start("fails always", failing)) {
      assertThat(log.next()).startsWith("Work failed; please report this: ");
      assertThat(ended.await(20, TimeUnit.SECONDS)).isTrue();
      assertThat(worker.failure()).isPresent();
    } finally {
      Thread.setDefaultUncaughtExceptionHandler(before);
    }
  }
}
