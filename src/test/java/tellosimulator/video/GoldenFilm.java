package tellosimulator.video;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import tellosimulator.model.VideoSettings;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.testing.SteppedDrone;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.video.codec.AccessUnit;
import tellosimulator.video.codec.H264Encoder;

/** Films a flight; its main method prints the hash of the film, on any system and processor. */
final class GoldenFilm {

  static final String[] FLIGHT = {"rc 20 30 10 40", "rc 0 -40 0 -90", "flip l", "land"};

  private static final VideoFormat FORMAT = VideoFormat.of(VideoSettings.DEFAULT);

  /** Interval of frames [s]. */
  private static final double PERIOD = 0.04;

  private static final int FRAMES_OF_COMMAND = 12;

  private GoldenFilm() {}

  public static void main(String[] arguments) throws NoSuchAlgorithmException {
    System.out.println(hash(FLIGHT));
  }

  /** Flies the commands after a takeoff, and returns the SHA-256 of the film. */
  static String hash(String... commands) throws NoSuchAlgorithmException {
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
