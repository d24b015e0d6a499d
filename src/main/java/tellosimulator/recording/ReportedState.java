package tellosimulator.recording;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import tellosimulator.math.Vec3;

/**
 * The values of a state line that describe motion, which are all that is known of how a real drone
 * moved. Immutable; for any thread.
 *
 * @param time when it was sent, simulated seconds since the simulation began
 * @param drone its number, from 1
 * @param heightCm above the takeoff [cm]
 * @param yawDeg clockwise seen from above, from where the drone looked when it was switched on
 *     [degrees]
 * @param velocity x along yaw 0, y to the right of it, z down [m/s]
 */
public record ReportedState(double time, int drone, double heightCm, double yawDeg, Vec3 velocity) {

  /** Unit of the velocities in a state line [m/s]. Source: SDK 3.0 User Guide. */
  private static final double DECIMETER = 0.1;

  private static final Set<String> WANTED = Set.of("h", "yaw", "vgx", "vgy", "vgz");

  /**
   * Reads all of a recording. State lines that are damaged are left out.
   *
   * @return in the order in which they were sent; empty if none are kept
   * @throws IOException if they cannot be read
   */
  public static List<ReportedState> readAll(Path folder) throws IOException {
    List<ReportedState> states = new ArrayList<>();
    RecordedDatagram.readAll(
        folder,
        sent -> {
          if (sent.kind().equals("state")) {
            of(sent.time(), sent.drone(), sent.text()).ifPresent(states::add);
          }
        });
    return states;
  }

  /**
   * Reads a state line.
   *
   * @param text such as {@code pitch:0;roll:0;yaw:-26;…}
   * @return empty if it lacks yaw, height or velocity
   */
  static Optional<ReportedState> of(double time, int drone, String text) {
    Map<String, Double> said = StateNumbers.of(text);
    if (!said.keySet().containsAll(WANTED)) {
      return Optional.empty();
    }
    Vec3 velocity = new Vec3(said.get("vgx"), said.get("vgy"), said.get("vgz"));
    return Optional.of(
        new ReportedState(time, drone, said.get("h"), said.get("yaw"), velocity.times(DECIMETER)));
  }
}
