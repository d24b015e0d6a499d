package tellosimulator.time;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(value = 20, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class TickerTest {

  private static final long PERIOD = 2_000_000;

  private final Ticker ticker = new Ticker();

  @Test
  void ticksNeverComeEarly() {
    ticker.restart();
    long begun = ticker.nanos();
    for (int i = 0; i < 20; i++) {
      assertThat(ticker.awaitTick(PERIOD)).isTrue();
    }

    assertThat(ticker.nanos() - begun).isGreaterThanOrEqualTo(19 * PERIOD - PERIOD / 100);
  }

  @Test
  void ofMissedTicksThreeAreMadeUpFor() {
    long period = 100_000_000;
    ticker.restart();
    ticker.awaitTick(period);
    ticker.pauseUntil(ticker.nanos() + 6 * period);
    long late = ticker.nanos();
    for (int i = 0; i < 4; i++) {
      ticker.awaitTick(period);
    }

    assertThat(ticker.due()).as("all came at once").isLessThan(late + 2 * period);
    ticker.awaitTick(period);
    assertThat(ticker.nanos()).as("the next took its time").isGreaterThanOrEqualTo(late + period);
  }

  @Test
  void wakingEndsTheWaitForATick() {
    long hour = TimeUnit.HOURS.toNanos(1);
    ticker.restart();
    ticker.awaitTick(hour);
    new Thread(ticker::wake, "waker").start();

    assertThat(ticker.awaitTick(hour)).isFalse();
  }

  @Test
  void wakingBeforeRestIsNotForgotten() {
    ticker.wake();
    ticker.rest();

    ticker.restart();
    assertThat(ticker.awaitTick(PERIOD)).isTrue();
  }

  @Test
  void wakingDoesNotShortenAPause() {
    long begun = ticker.nanos();
    new Thread(ticker::wake, "waker").start();
    ticker.pauseUntil(begun + 10 * PERIOD);

    assertThat(ticker.nanos() - begun).isGreaterThanOrEqualTo(10 * PERIOD);
  }
}
