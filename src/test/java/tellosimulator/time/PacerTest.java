package tellosimulator.time;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What of the pacer does not depend on the wall clock. */
class PacerTest {

  @Test
  void asFastAsPossibleMeansWhileSomethingMoves() {
    Pacer pacer = new Pacer(TimeFactor.MAX);

    for (int i = 0; i < 1000; i++) {
      assertThat(pacer.stepDue(() -> Demand.DEBT)).isTrue();
    }
    assertThat(pacer.stepDue(() -> Demand.NONE)).isFalse();
  }

  @Test
  void byTheClockTimePassesAlsoWhileNothingMoves() {
    assertThat(new Pacer(TimeFactor.REAL_TIME).stepDue(() -> Demand.NONE)).isTrue();
  }

  @Test
  void inAPauseNoStepIsDue() {
    Pacer pacer = new Pacer(TimeFactor.MAX);

    pacer.setPaused(true);
    assertThat(pacer.paused()).isTrue();
    assertThat(pacer.stepDue(() -> Demand.DEBT)).isFalse();

    pacer.setPaused(false);
    assertThat(pacer.stepDue(() -> Demand.DEBT)).isTrue();
  }

  @Test
  void theFactorCanBeChanged() {
    Pacer pacer = new Pacer(TimeFactor.REAL_TIME);

    pacer.setFactor(TimeFactor.MAX);

    assertThat(pacer.factor()).isEqualTo(TimeFactor.MAX);
    assertThat(pacer.stepDue(() -> Demand.NONE)).isFalse();
  }

  @Test
  @Timeout(value = 60, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
  void unparkingEndsAWaitWithoutEnd() {
    Pacer pacer = new Pacer(TimeFactor.MAX);

    LockSupport.unpark(Thread.currentThread());
    pacer.await();

    assertThat(pacer.paused()).isFalse();
  }
}
