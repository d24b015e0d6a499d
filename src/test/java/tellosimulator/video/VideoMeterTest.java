package tellosimulator.video;

import static org.assertj.core.api.Assertions.assertThat;

import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import tellosimulator.video.VideoMeter.Sample;

class VideoMeterTest {

  private static final Offset<Double> TINY = Offset.offset(1e-6);

  private final VideoMeter meter = new VideoMeter();

  @Test
  void onePictureSaysNothingOfThePace() {
    VideoFigures figures = meter.count(new Sample(0, 1000, 4_000_000, 6_000_000));

    assertThat(figures).isEqualTo(new VideoFigures(0, 0, 4, 6));
  }

  @Test
  void countsPicturesAndBitsOfTheLastSecond() {
    VideoFigures figures = VideoFigures.NONE;
    for (int i = 0; i <= 100; i++) {
      figures = meter.count(new Sample(i * 40_000_000L, 5000, 2_000_000, 3_000_000));
    }

    assertThat(figures.framesPerSecond()).isCloseTo(25, TINY); // 1 s / 40 ms
    assertThat(figures.bitsPerSecond()).isCloseTo(25 * 5000 * 8, TINY);
    assertThat(figures.filmMs()).isCloseTo(2, TINY);
    assertThat(figures.encodeMs()).isCloseTo(3, TINY);
  }

  @Test
  void forgetsWhatWasBeforeARestart() {
    meter.count(new Sample(0, 1000, 0, 0));
    meter.restart();

    assertThat(meter.count(new Sample(10, 1000, 0, 0)).framesPerSecond()).isZero();
  }
}
