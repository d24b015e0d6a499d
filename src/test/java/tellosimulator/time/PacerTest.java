package tellosimulator.time;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PacerTest {

  /** The wall clock, and its increment on each reading [ns]. */
  private long nanos;

  private long step;

  @Test
  void asFastAsPossibleMeansWhileSomethingMoves() {
    Pacer pacer = new Pacer(TimeFactor.MAX);

    for (int i = 0; i < 1000; i++) {
      assertThat(pacer.stepDue(() -> PendingWork.REPLY)).isTrue();
    }
    assertThat(pacer.stepDue(() -> PendingWork.NONE)).isFalse();
  }

  @Test
  void byTheClockTimePassesAlsoWhileNothingMoves() {
    assertThat(new Pacer(TimeFactor.REAL_TIME).stepDue(() -> PendingWork.NONE)).isTrue();
  }

  @Test
  void inAPauseNoStepIsDue() {
    Pacer pacer = new Pacer(TimeFactor.MAX);

    pacer.setPaused(true);
    assertThat(pacer.paused()).isTrue();
    assertThat(pacer.stepDue(() -> PendingWork.REPLY)).isFalse();

    pacer.setPaused(false);
    assertThat(pacer.stepDue(() -> PendingWork.REPLY)).isTrue();
  }

  @Test
  void theFactorCanBeChanged() {
    Pacer pacer = new Pacer(TimeFactor.REAL_TIME);

    pacer.setFactor(TimeFactor.MAX);

    assertThat(pacer.factor()).isEqualTo(TimeFactor.MAX);
    assertThat(pacer.stepDue(() -> PendingWork.NONE)).isFalse();
  }

  @Test
  @Timeout(value = 60, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
  void unparkingEndsAWaitWithoutEnd() {
    Pacer pacer = new Pacer(TimeFactor.MAX);

    LockSupport.unpark(Thread.currentThread());
    pacer.await();

    assertThat(pacer.paused()).isFalse();
  }

  @Test
  void motionWaitsForTheNextCommandForTwoSecondsInWhichThisProcessRuns() {
    Pacer pacer = new Pacer(TimeFactor.MAX, this::nanos);
    step = 10_000_000_000L; // each wait takes ten seconds, as after a halt of the machine
    int waits = 0;
    while (!pacer.stepDue(() -> PendingWork.MOTION)) {
      LockSupport.unpark(Thread.currentThread());
      pacer.await();
      waits++;
    }

    assertThat(waits).as("waits of at most 50 ms").isEqualTo(40);
    assertThat(pacer.stepDue(() -> PendingWork.MOTION)).isTrue();
    assertThat(pacer.stepDue(() -> PendingWork.REPLY)).isTrue();
    assertThat(pacer.stepDue(() -> PendingWork.MOTION)).as("waits anew").isFalse();
  }

  @Test
  void whatIsCaughtUpIsNotLost() {
    Pacer pacer = new Pacer(TimeFactor.REAL_TIME, this::nanos);
    nanos = 200_000_000;

    int steps = 0;
    while (pacer.stepDue(() -> PendingWork.NONE)) {
      steps++;
    }

    assertThat(steps).isEqualTo(41);
    assertThat(pacer.lostSeconds()).isZero();
    assertThat(pacer.lossToTell()).isEmpty();
  }

  /** One second late: the first and the last step run, but not the 199 in between. */
  @ParameterizedTest
  @CsvSource({"1, 0.995", "20, 19.995"})
  void whatIsGivenUpIsLostSimulatedTime(double factor, double lost) {
    Pacer pacer = new Pacer(new TimeFactor(factor), this::nanos);
    nanos = 1_000_000_000;

    assertThat(pacer.stepDue(() -> PendingWork.NONE)).isTrue();
    assertThat(pacer.lostSeconds()).isCloseTo(lost, within(1e-9));
    assertThat(pacer.stepDue(() -> PendingWork.NONE)).as("the one that is due now").isTrue();
    assertThat(pacer.stepDue(() -> PendingWork.NONE)).as("the next one, on time").isFalse();
  }

  @Test
  void lossesAreToldAtOnceAndThenOnceAMinute() {
    Pacer pacer = new Pacer(TimeFactor.REAL_TIME, this::nanos);
    lose(pacer, 0.9);
    assertThat(pacer.lossToTell()).as("too little").isEmpty();
    lose(pacer, 0.9);
    assertThat(pacer.lossToTell()).hasValueCloseTo(1.8, within(1e-6));

    for (int i = 0; i < 30; i++) {
      lose(pacer, 1);
      assertThat(pacer.lossToTell()).isEmpty();
    }
    lose(pacer, 30);
    assertThat(pacer.lossToTell()).hasValueCloseTo(60.0, within(1e-6));
    assertThat(pacer.lossToTell()).isEmpty();
  }

  @Test
  void aLossThatIsForgivenIsNotTold() {
    Pacer pacer = new Pacer(TimeFactor.REAL_TIME, this::nanos);
    lose(pacer, 5);
    pacer.forgiveLoss();
    assertThat(pacer.lostSeconds()).isZero();
    assertThat(pacer.lossToTell()).isEmpty();

    lose(pacer, 2);
    assertThat(pacer.lossToTell()).hasValueCloseTo(2.0, within(1e-6));
  }

  /** Simulates a delay of which all steps are lost except for the two that run now. */
  private void lose(Pacer pacer, double seconds) {
    nanos += Math.round((seconds + SimTime.STEP) * 1e9);
    assertThat(pacer.stepDue(() -> PendingWork.NONE)).isTrue();
    assertThat(pacer.stepDue(() -> PendingWork.NONE)).isTrue();
    nanos += SimTime.STEP_NANOS;
  }

  private long nanos() {
    nanos += step;
    return nanos;
  }
}
