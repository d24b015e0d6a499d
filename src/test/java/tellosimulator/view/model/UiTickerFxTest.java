package tellosimulator.view.model;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import javafx.animation.AnimationTimer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.testfx.api.FxToolkit;

/** The conditions under which the window ticks once a frame, or rarely. */
class UiTickerFxTest {

  private static final long SECOND = 1_000_000_000;

  private final AtomicBoolean still = new AtomicBoolean(true);
  private final AtomicInteger beats = new AtomicInteger();
  private final AtomicLong lastNanos = new AtomicLong();
  private UiTicker ticker;

  @BeforeEach
  void build() throws TimeoutException {
    FxToolkit.registerPrimaryStage();
    ticker = onFxThread(() -> new UiTicker(beats::incrementAndGet, still::get));
    ticker.onTick(lastNanos::set);
  }

  @AfterEach
  void stop() {
    onFxThread(
        () -> {
          ticker.stop();
          return ticker;
        });
  }

  @Test
  void whenNothingHasHappenedForTwoSecondsItIsIdle() {
    assertThat(idleAfter(0)).isFalse();
    assertThat(idleAfter(2 * SECOND - 1)).isFalse();

    assertThat(idleAfter(2 * SECOND)).isTrue();
  }

  @Test
  void whileSomethingMovesItIsNeverIdle() {
    still.set(false);
    assertThat(idleAfter(0)).isFalse();
    assertThat(idleAfter(9 * SECOND)).isFalse();

    still.set(true);

    assertThat(idleAfter(10 * SECOND)).isFalse();
    assertThat(idleAfter(11 * SECOND)).isTrue();
  }

  @Test
  void whatHappensBeforeCountsFromTheNextBeat() {
    idleAfter(0);
    ticker.wake();
    assertThat(idleAfter(2 * SECOND)).isFalse();
    assertThat(idleAfter(4 * SECOND - 1)).isFalse();

    assertThat(idleAfter(4 * SECOND)).isTrue();
  }

  @Test
  void whatSomebodyDoesInTheWindowEndsItAtOnce() {
    becomeIdle();

    boolean idle =
        onFxThread(
            () -> {
              ticker.wake();
              return ticker.idle();
            });

    assertThat(idle).isFalse();
  }

  @Test
  void whatHappensOnAnotherThreadEndsItWithABeatThatShowsIt() {
    becomeIdle();
    int before = beats.get();

    ticker.wake();

    waitUntil(() -> !ticker.idle());
    assertThat(beats.get()).isGreaterThan(before);
  }

  @Test
  void whatNobodyToldOfIsSeenAtASlowBeat() {
    onFxThread(this::start);
    becomeIdle();

    still.set(false);

    waitUntil(() -> !ticker.idle());
  }

  @Test
  void idleItBeatsOnButFarLessOftenThanTheToolkit() {
    onFxThread(this::start);
    assertThat(beatsWithin(60)).isGreaterThanOrEqualTo(50);

    becomeIdle();

    int before = beats.get();
    assertThat(beatsWithin(60)).isLessThan(30); // two a second, of about sixty
    waitUntil(() -> beats.get() > before);
  }

  @Test
  void afterItWasStirredItBeatsOnceAFrameAgain() {
    onFxThread(this::start);
    becomeIdle();

    ticker.wake();
    waitUntil(() -> !ticker.idle());

    assertThat(beatsWithin(60)).isGreaterThanOrEqualTo(50);
  }

  @Test
  void stoppedItBeatsNoMore() {
    onFxThread(this::start);
    becomeIdle();
    stop();

    ticker.wake();

    assertThat(beatsWithin(10)).isZero();
  }

  private UiTicker start() {
    ticker.start();
    return ticker;
  }

  private boolean idleAfter(long nanos) {
    return onFxThread(
        () -> {
          ticker.tick(nanos);
          return ticker.idle();
        });
  }

  /** Advances the time by two seconds; a running ticker uses the toolkit's time. */
  private void becomeIdle() {
    waitUntil(
        () -> {
          if (lastNanos.get() == 0) {
            idleAfter(1);
          }
          return idleAfter(lastNanos.get() + 2 * SECOND);
        });
  }

  private int beatsWithin(int frames) {
    AtomicInteger left = new AtomicInteger(frames);
    int before = beats.get();
    AnimationTimer counter =
        new AnimationTimer() {
          @Override
          public void handle(long nanos) {
            left.decrementAndGet();
          }
        };
    counter.start();
    waitUntil(() -> left.get() <= 0);
    counter.stop();
    return beats.get() - before;
  }
}
