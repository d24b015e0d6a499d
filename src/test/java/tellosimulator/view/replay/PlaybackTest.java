package tellosimulator.view.replay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class PlaybackTest {

  private final Playback playback = new Playback(4, 15);

  @Test
  void itGoesOnWithTheWallClockTimesItsSpeedAndStopsAtTheEnd() {
    playback.toggle();
    pass(1_000_000_000L, 0.2);
    assertThat(playback.time()).isCloseTo(4.2, within(1e-9));

    playback.faster(1);
    pass(1_200_000_000L, 0.2);
    assertThat(playback.time()).as("twice as fast").isCloseTo(4.6, within(1e-9));

    playback.seek(14.9);
    pass(1_400_000_000L, 0.2);
    assertThat(playback.time()).isEqualTo(15);
    assertThat(playback.playingProperty().get()).isFalse();

    playback.toggle();
    assertThat(playback.time()).as("it begins anew").isEqualTo(4);
  }

  @Test
  void itNeverLeavesTheFlightAndKnowsNoOtherSpeeds() {
    playback.step(-1);
    assertThat(playback.time()).isEqualTo(4);
    playback.step(100);
    assertThat(playback.time()).isEqualTo(15);
    playback.faster(-10);
    assertThat(playback.speedProperty().get()).isEqualTo(0.25);
    playback.faster(10);
    assertThat(playback.speedProperty().get()).isEqualTo(8);
  }

  @Test
  void whileSomebodyHoldsTheSliderItWaits() {
    playback.toggle();
    playback.heldProperty().set(true);
    pass(1_000_000_000L, 0.2);

    assertThat(playback.time()).isEqualTo(4);
    assertThat(playback.playingProperty().get()).isTrue();
  }

  private void pass(long from, double seconds) {
    playback.advance(from);
    playback.advance(from + Math.round(seconds * 1e9));
  }
}
