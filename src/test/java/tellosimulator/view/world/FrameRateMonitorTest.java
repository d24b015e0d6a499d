package tellosimulator.view.world;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class FrameRateMonitorTest {

  private final FrameRateMonitor monitor = new FrameRateMonitor();
  private long nanos;

  @Test
  void manyFramesASecondAreFluent() {
    show(30, 25);

    assertThat(monitor.jerky()).isFalse();
  }

  @Test
  void fewFramesASecondAreNotButOnlyAfterTheWarmUp() {
    show(15, 6);
    assertThat(monitor.jerky()).isFalse();

    show(15, 6);
    assertThat(monitor.jerky()).isTrue();
  }

  @Test
  void aVerySlowPictureIsJudgedThoughItHalts() {
    for (int i = 0; i < 10; i++) {
      show(4, 2);
      nanos += 600_000_000;
    }

    assertThat(monitor.jerky()).isTrue();
  }

  @Test
  void pausesDoNotCount() {
    show(30, 7);
    for (int i = 0; i < 30; i++) {
      nanos += 500_000_000;
      monitor.frame(nanos);
    }
    show(30, 6);

    assertThat(monitor.jerky()).isFalse();
  }

  @Test
  void itJudgesAnewAfterARestart() {
    show(15, 12);
    monitor.restart();
    assertThat(monitor.jerky()).isFalse();

    show(15, 12);
    assertThat(monitor.jerky()).isTrue();
  }

  private void show(int rate, int seconds) {
    for (int i = 0; i < rate * seconds; i++) {
      nanos += 1_000_000_000 / rate;
      monitor.frame(nanos);
    }
  }
}
