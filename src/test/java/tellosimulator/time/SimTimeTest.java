package tellosimulator.time;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;

class SimTimeTest {

  @Test
  void aStepIsFiveMilliseconds() {
    assertThat(SimTime.ZERO.next()).isEqualTo(SimTime.ZERO.plus(0.005));
    assertThat(SimTime.STEP).isEqualTo(0.005);
  }

  @Test
  void momentsAreOrderedAndSubtracted() {
    SimTime early = SimTime.ZERO.plus(1);
    SimTime late = SimTime.ZERO.plus(2.5);

    assertThat(late).isGreaterThan(early);
    assertThat(early.isBefore(late)).isTrue();
    assertThat(early.isBefore(early)).isFalse();
    assertThat(late.since(early)).isEqualTo(1.5);
    assertThat(early.since(late)).isEqualTo(-1.5);
  }

  @Test
  void thereIsNothingBeforeTheStart() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new SimTime(-1))
        .withMessage("nanos is -1, but must be 0 or more");
  }
}
