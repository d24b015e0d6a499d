package tellosimulator.view.video;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import javafx.scene.image.Image;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.testfx.api.FxToolkit;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.video.VideoFigures;
import tellosimulator.video.VideoStreams;
import tellosimulator.video.camera.CameraId;
import tellosimulator.video.codec.H264Encoder;
import tellosimulator.video.picture.Picture;
import tellosimulator.world.Room;

class VideoViewFxTest {

  private static final Pose START = new Pose(Vec3.ZERO, Attitude.LEVEL);

  private final AtomicInteger brightness = new AtomicInteger(100);
  private VideoStreams streams;
  private VideoView view;

  @BeforeEach
  void watch() throws TimeoutException {
    FxToolkit.registerPrimaryStage();
    SimConfig two =
        SimConfig.DEFAULT.withRoom(
            Room.DEFAULT, List.of(START, new Pose(new Vec3(0, 1, 0), Attitude.LEVEL)));
    SimSnapshot snapshot = new Simulation(two, drone -> datagram -> {}, List.of()).snapshot();
    streams = new VideoStreams(() -> snapshot, () -> this::film, H264Encoder::new);
    view =
        onFxThread(
            () -> {
              VideoView made = new VideoView();
              made.watch(streams.stream(1));
              return made;
            });
  }

  @AfterEach
  void close() {
    streams.close();
  }

  /** Renders grey for the first drone, and blue for the second one. */
  private void film(SimSnapshot snapshot, CameraId shot, Picture picture) {
    Arrays.fill(picture.y(), (byte) brightness.get());
    Arrays.fill(picture.u(), (byte) (shot.drone() == 1 ? 128 : 240));
  }

  @Test
  void itShowsWhatTheStreamShows() {
    // (100 - 16) 255 / 219 = 98 = 0x62
    waitUntil(() -> color() == 0xff626262);
    Image first = onFxThread(view::getImage);

    brightness.set(200);

    // (200 - 16) 255 / 219 = 214 = 0xd6
    waitUntil(() -> color() == 0xffd6d6d6);
    assertThat(onFxThread(view::getImage)).as("no new image for each picture").isSameAs(first);
    assertThat(onFxThread(() -> view.figuresProperty().get().bitsPerSecond())).isZero();
  }

  @Test
  void largerThanHalfOfThePictureItShowsAllPixels() {
    waitUntil(() -> color() != 0);
    assertThat(onFxThread(() -> view.getImage().getWidth())).isEqualTo(480);

    onFxThread(
        () -> {
          view.setFitWidth(481);
          return true;
        });

    waitUntil(() -> color() != 0 && view.getImage().getWidth() == 960);
    waitUntil(() -> color() == 0xff626262);
  }

  @Test
  void itChangesToAnotherStreamAndRests() {
    waitUntil(() -> color() == 0xff626262);

    onFxThread(
        () -> {
          view.watch(streams.stream(2));
          return true;
        });
    assertThat(onFxThread(view::getImage)).as("nothing of the one before").isNull();
    waitUntil(() -> (color() & 255) > 250);

    onFxThread(
        () -> {
          view.rest();
          return true;
        });
    assertThat(onFxThread(view::getImage)).isNull();
    assertThat(onFxThread(() -> view.figuresProperty().get())).isEqualTo(VideoFigures.NONE);
  }

  /** Returns the colour in the middle; 0 while there is no picture. */
  private int color() {
    view.advance();
    Image image = view.getImage();
    return image == null
        ? 0
        : image.getPixelReader().getArgb((int) image.getWidth() / 2, (int) image.getHeight() / 2);
  }
}
