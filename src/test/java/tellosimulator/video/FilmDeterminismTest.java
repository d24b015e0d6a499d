package tellosimulator.video;

import static org.assertj.core.api.Assertions.assertThat;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;
import tellosimulator.model.VideoSettings;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.testing.SteppedDrone;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.video.codec.AccessUnit;
import tellosimulator.video.codec.H264Encoder;

/**
 * The same seed and the same commands result in the same video, byte for byte, on each machine and
 * JDK: simulation, camera and encoder use no function of {@code Math} whose last bits may differ.
 */
class FilmDeterminismTest {

  /** SHA-256 of the stream, to be updated when camera, room or encoder change on purpose. */
  private static final String EXPECTED =
      "2ec3bf2ede2b51be4b458db706ff9ab8430817fc2b15a4a59d185222f104326b";

  private static final VideoFormat FORMAT = VideoFormat.of(VideoSettings.DEFAULT);

  /** Interval of frames [s]. */
  private static final double PERIOD = 0.04;

  private static final int FRAMES_OF_COMMAND = 12;

  @Test
  void aFlightGivesTheSameBytesEverywhere() throws Exception {
    assertThat(film("rc 20 30 10 40", "rc 0 -40 0 -90", "flip l", "land")).isEqualTo(EXPECTED);
  }

  @Test
  void anotherFlightGivesOthers() throws Exception {
    assertThat(film("rc 20 30 10 41", "rc 0 -40 0 -90", "flip l", "land")).isNotEqualTo(EXPECTED);
  }

  private static String film(String... commands) throws NoSuchAlgorithmException {
    MessageDigest digest = MessageDigest.getInstance("SHA-256");
    SteppedDrone drone = SteppedDrone.of(SimConfig.DEFAULT);
    SimSnapshot room =
        new Simulation(SimConfig.DEFAULT, number -> datagram -> {}, List.of()).snapshot();
    FramePipeline film =
        new FramePipeline(1, new SoftwareCameras(DroneOptics.DEFAULT).get(), H264Encoder::new);
    long frame = 0;
    List<String> flight = new ArrayList<>(List.of("command", "takeoff"));
    flight.addAll(List.of(commands));
    for (String command : flight) {
      drone.send(command);
      for (int i = 0; i < FRAMES_OF_COMMAND; i++) {
        drone.advance(PERIOD);
        film.capture(room.withDrones(List.of(drone.snapshot())), FORMAT);
        AccessUnit encoded = film.encode(Math.round(frame++ * PERIOD * 1e9), false);
        digest.update(encoded.bytes(), 0, encoded.size());
      }
    }
    return HexFormat.of().formatHex(digest.digest());
  }
}
