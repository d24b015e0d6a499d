package tellosimulator.video;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.List;
import java.util.function.Supplier;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.Simulation;
import tellosimulator.testing.CapturedLog;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.video.codec.H264Encoder;

/** Photos of the software camera. */
@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class PhotoTest {

  private final Simulation simulation =
      new Simulation(SimConfig.DEFAULT, drone -> datagram -> {}, List.of());

  private byte[] photo(Supplier<FrameSource> cameras) {
    try (VideoStreams streams = new VideoStreams(simulation::snapshot, cameras, H264Encoder::new)) {
      return streams.stream(1).photo(simulation.snapshot(), 0.9f).get();
    }
  }

  @Test
  void aPhotoIsAJpegFileOfWhatTheCameraSees() throws IOException {
    byte[] bytes = photo(new SoftwareCameras(DroneOptics.DEFAULT));

    BufferedImage image = ImageIO.read(new ByteArrayInputStream(bytes));
    assertThat(List.of(image.getWidth(), image.getHeight())).containsExactly(2592, 1936);
    assertThat(bytes.length).isBetween(200_000, 2_000_000);
    assertThat(image.getRGB(0, 0)).isNotEqualTo(image.getRGB(1296, 1900)); // wall and floor
  }

  @Test
  void itsWidthIsASetting() throws IOException {
    DroneOptics small = new DroneOptics(Math.toRadians(55), 0, 640);

    BufferedImage image = ImageIO.read(new ByteArrayInputStream(photo(new SoftwareCameras(small))));
    assertThat(List.of(image.getWidth(), image.getHeight())).containsExactly(640, 478);
  }

  @Test
  void aPhotoThatFailsIsEmpty() throws InterruptedException {
    FrameSource broken =
        (snapshot, camera, picture) -> {
          throw new OutOfMemoryError("as a test wants it");
        };

    try (CapturedLog log = CapturedLog.of(PhotoQueue.class)) {
      assertThat(photo(() -> broken)).isEmpty();
      assertThat(log.next())
          .isEqualTo("The photo of drone 1 failed: java.lang.OutOfMemoryError: as a test wants it");
    }
  }
}
