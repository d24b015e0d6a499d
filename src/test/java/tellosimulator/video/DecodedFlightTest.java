package tellosimulator.video;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.command.Packetizer;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.Motion;
import tellosimulator.model.VideoSettings;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.testing.Ffmpeg;
import tellosimulator.testing.Ffmpeg.Decoded;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.video.codec.AccessUnit;
import tellosimulator.video.codec.H264Encoder;

/** Two seconds of flight, in which the drone turns and leans, decoded by an independent decoder. */
@NeedsTool(Tool.FFMPEG)
class DecodedFlightTest {

  private static final int WIDTH = DroneOptics.WIDTH;
  private static final int HEIGHT = DroneOptics.HEIGHT;
  private static final int PICTURES = 61;

  /** Turn from picture to picture. At 30 pictures a second, one degree is 30 degrees/s. */
  private static final double TURN = Math.toRadians(1);

  /**
   * Minimum similarity [dB], far above that of different pictures. Measured: 30 to 36 at 2.5
   * Mbit/s.
   */
  private static final double FAITHFUL_DB = 27;

  private static final VideoFormat FORMAT = VideoFormat.of(VideoSettings.DEFAULT);

  @TempDir private Path folder;

  private final FramePipeline film =
      new FramePipeline(1, new SoftwareCameras(DroneOptics.DEFAULT).get(), H264Encoder::new);
  private final SimSnapshot room =
      new Simulation(SimConfig.DEFAULT, drone -> datagram -> {}, List.of()).snapshot();
  private final List<byte[]> seen = new ArrayList<>();
  private final List<byte[]> packets = new ArrayList<>();

  @Test
  void aStrictDecoderShowsWhatTheCameraSawWithoutAComplaint() throws Exception {
    fly();

    Decoded decoded =
        Ffmpeg.decode(stream(packets), WIDTH * HEIGHT, folder, "-err_detect", "explode");

    assertThat(decoded.complaints()).isEmpty();
    assertThat(decoded.pictures()).hasSize(PICTURES);
    for (int i = 0; i < PICTURES; i++) {
      assertThat(likeness(decoded.pictures().get(i), seen.get(i)))
          .as("PSNR of picture %d", i)
          .isGreaterThan(FAITHFUL_DB);
    }
  }

  @Test
  void afterLostPacketsThePictureRecoversWithTheNextKeyPicture() throws Exception {
    fly();
    Random random = new Random(7);
    List<byte[]> arrived = new ArrayList<>();
    int lost = 0;
    for (byte[] packet : packets) {
      boolean early = arrived.size() + lost < packets.size() / 2; // the last second arrives whole
      if (early && random.nextInt(100) < 5) {
        lost++;
      } else {
        arrived.add(packet);
      }
    }
    assertThat(lost).isGreaterThan(5);

    Decoded decoded = Ffmpeg.decode(stream(arrived), WIDTH * HEIGHT, folder);

    List<byte[]> pictures = decoded.pictures();
    assertThat(likeness(pictures.get(pictures.size() - 1), seen.get(PICTURES - 1)))
        .isGreaterThan(FAITHFUL_DB);
  }

  /** Turns to the right while leaning to the left and back. */
  private void fly() {
    for (int i = 0; i < PICTURES; i++) {
      double bank = Math.toRadians(8) * Math.sin(i / 10.0);
      Attitude leaning = new Attitude(Math.cos(bank / 2), Math.sin(bank / 2), 0, 0);
      Pose pose = new Pose(new Vec3(-1, 0, 1), Attitude.ofHeading(-i * TURN).after(leaning));
      seen.add(film.capture(at(pose), FORMAT).y().clone());
      AccessUnit encoded = film.encode(i * FORMAT.period(), false);
      packets.addAll(new VideoFaults(1).packets(encoded, Packetizer.RAW));
    }
  }

  private SimSnapshot at(Pose pose) {
    DroneSnapshot drone = room.drones().get(0);
    return room.withDrones(
        List.of(drone.withState(drone.state().withMotion(Motion.restingAt(pose)))));
  }

  private static byte[] stream(List<byte[]> packets) throws IOException {
    ByteArrayOutputStream stream = new ByteArrayOutputStream();
    for (byte[] packet : packets) {
      stream.write(packet);
    }
    return stream.toByteArray();
  }

  /** Peak signal-to-noise ratio [dB]; ffmpeg's grey has the full range, of 16 to 235. */
  private static double likeness(byte[] gray, byte[] brightness) {
    double squares = 0;
    for (int i = 0; i < gray.length; i++) {
      double expected = ((brightness[i] & 0xff) - 16) * 255.0 / 219;
      double error = (gray[i] & 0xff) - Math.max(0, Math.min(255, expected));
      squares += error * error;
    }
    return 10 * Math.log10(255.0 * 255 * gray.length / squares);
  }
}
