package tellosimulator.video;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import tellosimulator.model.VideoOption;
import tellosimulator.model.VideoSettings;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.video.camera.CameraId;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.video.codec.AccessUnit;
import tellosimulator.video.codec.VideoEncoder;
import tellosimulator.video.picture.Picture;

class FramePipelineTest {

  /** A fifth of a second [ns]. */
  private static final long FIFTH = 200_000_000;

  private final List<String> asked = new ArrayList<>();
  private final SimSnapshot snapshot =
      new Simulation(SimConfig.DEFAULT, drone -> datagram -> {}, List.of()).snapshot();
  private final List<CameraId> taken = new ArrayList<>();
  private final FramePipeline film =
      new FramePipeline(
          1,
          new Camera(),
          (width, height) -> {
            asked.add("encoder " + width + "x" + height);
            return new Recorder();
          });

  /** A camera that logs the requested frames. */
  private final class Camera implements FrameSource {
    @Override
    public void film(SimSnapshot moment, CameraId shot, Picture picture) {
      taken.add(shot);
    }
  }

  /** An encoder that logs its calls. */
  private final class Recorder implements VideoEncoder {
    @Override
    public void setRate(int framesPerSecond, int bitsPerSecond) {
      asked.add(framesPerSecond + "/s " + bitsPerSecond);
    }

    @Override
    public AccessUnit encode(Picture picture, boolean key) {
      asked.add(key ? "key" : "next");
      return key ? FakePicture.of(13, 8, 100) : FakePicture.of(50);
    }
  }

  @Test
  void afterARestartFramesAreEncodedAsByANewEncoder() {
    VideoFormat format = VideoFormat.of(VideoSettings.DEFAULT);
    film.capture(snapshot, format);
    film.encode(0, false);
    film.encode(1, false);
    film.restart();
    film.capture(snapshot, format);
    film.encode(2, false);

    assertThat(asked)
        .containsExactly(
            "encoder 960x720",
            "30/s 2500000",
            "key",
            "next",
            "encoder 960x720",
            "30/s 2500000",
            "key");
  }

  @Test
  void aStreamBeginsWithAKeyPictureAndHasOneEachSecond() {
    VideoFormat format =
        VideoFormat.of(VideoSettings.DEFAULT.with(VideoOption.FRAMES_PER_SECOND, 5));
    for (int i = 0; i < 11; i++) {
      film.capture(snapshot, format);
      film.encode(i * FIFTH, false);
    }

    assertThat(asked)
        .containsExactly(
            "encoder 960x720",
            "5/s 2500000",
            "key",
            "next",
            "next",
            "next",
            "next",
            "key",
            "next",
            "next",
            "next",
            "next",
            "key");
  }

  @Test
  void alsoWhereAMachineIsTooSlowForAllPicturesThereIsAKeyPictureEachSecond() {
    VideoFormat format = VideoFormat.of(VideoSettings.DEFAULT);
    for (int i = 0; i < 6; i++) {
      film.capture(snapshot, format);
      film.encode(2 * FIFTH * i, false); // 0, 0.4, 0.8, 1.2, 1.6, 2 s
    }

    assertThat(asked.subList(2, asked.size()))
        .containsExactly("key", "next", "next", "key", "next", "next");
  }

  @Test
  void aKeyPictureCanBeAskedForAtAnyTimeAndCounts() {
    VideoFormat format =
        VideoFormat.of(VideoSettings.DEFAULT.with(VideoOption.FRAMES_PER_SECOND, 5));
    for (int i = 0; i < 8; i++) {
      film.capture(snapshot, format);
      film.encode(i * FIFTH, i == 2);
    }

    assertThat(asked.subList(2, asked.size()))
        .containsExactly("key", "next", "key", "next", "next", "next", "next", "key");
  }

  @Test
  void anotherBitRateKeepsTheEncoderAndAnotherSizeMakesANewOne() {
    film.capture(snapshot, VideoFormat.of(VideoSettings.DEFAULT));
    film.encode(0, false);
    film.capture(snapshot, VideoFormat.of(VideoSettings.DEFAULT.with(VideoOption.BIT_RATE, 4)));
    film.encode(0, false);
    film.capture(
        snapshot,
        VideoFormat.of(
            VideoSettings.DEFAULT.with(VideoOption.BIT_RATE, 4).with(VideoOption.LINES, 480)));
    film.encode(0, false);

    assertThat(asked)
        .containsExactly(
            "encoder 960x720",
            "30/s 2500000",
            "key",
            "30/s 4000000",
            "key",
            "encoder 648x478",
            "30/s 4000000",
            "key");
  }

  @Test
  void thePictureOfTheAppMayBeWide() {
    Picture wide =
        film.capture(snapshot, VideoFormat.of(VideoSettings.DEFAULT.with(VideoOption.WIDE, 1)));

    assertThat(List.of(wide.width(), wide.height())).containsExactly(1280, 720);
  }

  @Test
  void theCameraThatLooksDownFilmsWhenItIsAskedFor() {
    Picture ahead = film.capture(snapshot, VideoFormat.of(VideoSettings.DEFAULT));
    assertThat(taken).containsExactly(new CameraId(1, false));
    assertThat(ahead.width()).isEqualTo(960);

    Picture below =
        film.capture(snapshot, VideoFormat.of(VideoSettings.DEFAULT.with(VideoOption.DOWNWARD, 1)));
    assertThat(taken).containsExactly(new CameraId(1, false), new CameraId(1, true));
    assertThat(List.of(below.width(), below.height())).containsExactly(320, 720);
  }
}
