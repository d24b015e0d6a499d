package tellosimulator.view.pilot;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import tellosimulator.view.pilot.OperatorClient.ReplyTimeout;
import tellosimulator.view.pilot.OperatorClient.ReplyTimeout.Clocks;

class ReplyTimeoutTest {

  private static final long SECOND = 1_000_000_000;

  private final ReplyTimeout patience = new ReplyTimeout(new Clocks(0, 100, false));

  @Test
  void countsSimulatedTime() {
    assertThat(patience.isOver(new Clocks(SECOND, 100 + ReplyTimeout.SIMULATED - 0.1, false)))
        .isFalse();
    assertThat(patience.isOver(new Clocks(SECOND, 100 + ReplyTimeout.SIMULATED, false))).isTrue();
  }

  @Test
  void slowMotionTakesAsLongAsItTakes() {
    for (int second = 1; second < 5000; second++) {
      Clocks slow = new Clocks(second * SECOND, 100 + second * 0.01, false);
      assertThat(patience.isOver(slow)).isFalse();
    }
  }

  @Test
  void endsWhenTimeStandsStillThoughItShouldNot() {
    assertThat(patience.isOver(new Clocks(ReplyTimeout.IDLE_NANOS - 1, 100, false))).isFalse();
    assertThat(patience.isOver(new Clocks(ReplyTimeout.IDLE_NANOS, 100, false))).isTrue();
  }

  @Test
  void doesNotEndInAPause() {
    assertThat(patience.isOver(new Clocks(1000 * SECOND, 100, true))).isFalse();
    assertThat(patience.isOver(new Clocks(1000 * SECOND + ReplyTimeout.IDLE_NANOS - 1, 100, false)))
        .isFalse();
  }
}
