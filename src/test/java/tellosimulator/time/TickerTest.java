package tellosimulator.time;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(value = 20, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class TickerTest {

  private static final long PERIOD = 2_000_000;

  private final Ticker metronome = new Ticker();

  @Test
  void ticksNeverComeEarly() {
    metronome.restart();
    long begun = metronome.nanos();
    for (int i = 0; i < 20; i++) {
      assertThat(metronome.awaitTick(PERIOD)).isTrue();
    }

    assertThat(metronome.nanos() - begun).isGreaterThanOrEqualTo(19 * PERIOD - PERIOD / 100);
  }

  @Test
  void ofMissedTicksThreeAreMadeUpFor() {
    long period = 100_000_000;
    metronome.restart();
    metronome.awaitTick(period);
    metronome.pauseUntil(metronome.nanos() + 6 * period);
    long late = metronome.nanos();
    for (int i = 0; i < 4; i++) {
      metronome.awaitTick(period);
    }

    assertThat(metronome.due()).as("all came at once").isLessThan(late + 2 * period);
    metronome.awaitTick(period);
    assertThat(metronome.nanos())
        .as("the next took its time")
        .isGreaterThanOrEqualTo(late + period);
  }

  @Test
  void wakingEndsTheWaitForATick() {
    long hour = TimeUnit.HOURS.toNanos(1);
    metronome.restart();
    metronome.awaitTick(hour);
    new Thread(metronome::wake, "waker").start();

    assertThat(metronome.awaitTick(hour)).isFalse();
  }

  @Test
  void wakingBeforeRestIsNotForgotten() {
    metronome.wake();
    metronome.rest();

    metronome.restart();
    assertThat(metronome.awaitTick(PERIOD)).isTrue();
  }

  @Test
  void wakingDoesNotShortenAPause() {
    long begun = metronome.nanos();
    new Thread(metronome::wake, "waker").start();
    metronome.pauseUntil(begun + 10 * PERIOD);

    assertThat(metronome.nanos() - begun).isGreaterThanOrEqualTo(10 * PERIOD);
  }
}
