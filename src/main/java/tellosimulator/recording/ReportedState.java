package tellosimulator.recording;

import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import tellosimulator.math.Vec3;

/**
 * What a state line said, as far as it tells how the drone moved. Immutable; for any thread.
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

  /**
   * Reads a state line.
   *
   * @param text such as {@code pitch:0;roll:0;yaw:-26;…}
   * @return empty if it lacks yaw, height or velocity
   */
  static Optional<ReportedState> of(double time, int drone, String text) {
    Map<String, String> fields = fields(text);
    try {
      Vec3 velocity = new Vec3(number(fields, "vgx"), number(fields, "vgy"), number(fields, "vgz"));
      return Optional.of(
          new ReportedState(
              time, drone, number(fields, "h"), number(fields, "yaw"), velocity.times(DECIMETER)));
    } catch (NumberFormatException e) { // a line that was corrupted on its way
      return Optional.empty();
    }
  }

  /** The fields of a state line, by their names. */
  static Map<String, String> fields(String text) {
    Map<String, String> fields = new TreeMap<>();
    for (String field : text.strip().split(";", -1)) {
      int colon = field.indexOf(':');
      if (colon > 0) {
        fields.put(field.substring(0, colon), field.substring(colon + 1));
      }
    }
    return fields;
  }

  private static double number(Map<String, String> fields, String name) {
    return Double.parseDouble(fields.getOrDefault(name, "missing"));
  }
}
