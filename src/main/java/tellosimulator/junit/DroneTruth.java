package tellosimulator.junit;

import java.util.List;

/**
 * What is really so about a drone at a moment, and what it did since the test began. Immutable.
 *
 * @param position where its feet are
 * @param heading where its nose points [degrees], clockwise seen from above, 0 along the room's x,
 *     within ±180
 * @param battery 0 to 100 [%]
 * @param flying whether its motors carry it
 * @param crashed whether it crashed, also if it was put back since
 * @param takeoffs how often it left the ground
 * @param touched what it touched in flight or crashed into, each with the moment
 * @param visited the names of the gates that it flew through, in order, each once
 * @param start where it stood when the test began
 * @param path where it flew, ten times a second, and where it is now
 */
public record DroneTruth(
    Position position,
    double heading,
    int battery,
    boolean flying,
    boolean crashed,
    int takeoffs,
    List<Touch> touched,
    List<String> visited,
    Position start,
    List<Position> path) {

  /**
   * Something that the drone touched.
   *
   * @param what such as {@code the front wall}
   * @param seconds when
   * @param speed how fast the drone was [cm/s]
   * @param crash whether it crashed into it
   */
  public record Touch(String what, double seconds, double speed, boolean crash) {}

  public DroneTruth {
    touched = List.copyOf(touched);
    visited = List.copyOf(visited);
    path = List.copyOf(path);
  }

  /** How high its feet are above the floor [cm]. */
  public double height() {
    return position.z();
  }

  /** How high its feet were at the most [cm]. */
  public double highest() {
    return path.stream().mapToDouble(Position::z).max().orElse(height());
  }

  /** How far it was from its start at the most, over the ground [cm]. */
  public double farthest() {
    return path.stream().mapToDouble(start::levelDistanceTo).max().orElse(0);
  }

  /** Whether it has flown, and stands on something with its motors off, unharmed. */
  public boolean landed() {
    return takeoffs > 0 && !flying && !crashed;
  }
}
