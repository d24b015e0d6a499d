package tellosimulator.view.world;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class FluencyWatchTest {

  private final FluencyWatch watch = new FluencyWatch();
  private long nanos;

  @Test
  void manyFramesASecondAreFluent() {
    show(30, 25);

    assertThat(watch.jerky()).isFalse();
  }

  @Test
  void fewFramesASecondAreNotButOnlyAfterTheWarmUp() {
    show(15, 6);
    assertThat(watch.jerky()).isFalse();

    show(15, 6);
    assertThat(watch.jerky()).isTrue();
  }

  @Test
  void aVerySlowPictureIsJudgedThoughItHalts() {
    for (int i = 0; i < 10; i++) {
      show(4, 2);
      nanos += 600_000_000;
    }

    assertThat(watch.jerky()).isTrue();
  }

  @Test
  void pausesDoNotCount() {
    show(30, 7);
    for (int i = 0; i < 30; i++) {
      nanos += 500_000_000;
      watch.frame(nanos);
    }
    show(30, 6);

    assertThat(watch.jerky()).isFalse();
  }

  @Test
  void itJudgesAnewAfterARestart() {
    show(15, 12);
    watch.restart();
    assertThat(watch.jerky()).isFalse();

    show(15, 12);
    assertThat(watch.jerky()).isTrue();
  }

  private void show(int rate, int seconds) {
    for (int i = 0; i < rate * seconds; i++) {
      nanos += 1_000_000_000 / rate;
      watch.frame(nanos);
    }
  }
}
