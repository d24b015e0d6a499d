package tellosimulator.recording;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import tellosimulator.math.Vec3;

/**
 * The values of a state line that describe motion. Nothing else is known about the motion of a real
 * drone. Immutable.
 *
 * @param time when the line was sent, in simulated seconds since the simulation began
 * @param drone the drone's number, from 1
 * @param heightCm height above the takeoff point [cm]
 * @param yawDeg yaw [degrees], clockwise seen from above; 0 is the drone's direction at power-on
 * @param velocity velocity [m/s]: x in the direction of yaw 0, y to the right of x, z down
 */
public record ReportedState(double time, int drone, double heightCm, double yawDeg, Vec3 velocity) {

  /** Unit of the velocities in a state line [m/s]. Documented: SDK 3.0 User Guide. */
  private static final double DECIMETER = 0.1;

  private static final Pattern NUMBER = Pattern.compile("-?\\d{1,9}([.]\\d{1,9})?");

  private static final Set<String> WANTED = Set.of("h", "yaw", "vgx", "vgy", "vgz");

  /**
   * Reads all state lines of a recording. Damaged lines are skipped.
   *
   * @return the states in the order of sending; empty if none were recorded
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
   * Parses a state line.
   *
   * @param text such as {@code pitch:0;roll:0;yaw:-26;…}
   * @return the state; empty if the line lacks yaw, height or velocity
   */
  static Optional<ReportedState> of(double time, int drone, String text) {
    Map<String, Double> said = numbers(text);
    if (!said.keySet().containsAll(WANTED)) {
      return Optional.empty();
    }
    Vec3 velocity = new Vec3(said.get("vgx"), said.get("vgy"), said.get("vgz"));
    return Optional.of(
        new ReportedState(time, drone, said.get("h"), said.get("yaw"), velocity.times(DECIMETER)));
  }

  /**
   * Parses those fields of a state line that hold a single number.
   *
   * @param text such as {@code pitch:0;roll:0;yaw:-26;…}
   * @return the values by key, in the order of the line; corrupted fields are left out
   */
  public static Map<String, Double> numbers(String text) {
    Map<String, Double> numbers = new LinkedHashMap<>();
    for (String field : text.strip().split(";", -1)) {
      int colon = field.indexOf(':');
      if (colon > 0 && NUMBER.matcher(field).region(colon + 1, field.length()).matches()) {
        numbers.put(field.substring(0, colon), Double.valueOf(field.substring(colon + 1)));
      }
    }
    return numbers;
  }
}
