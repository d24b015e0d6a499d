package tellosimulator.junit;

import java.util.List;

/**
 * The true state of a drone at one moment, and its history since the test began. Immutable.
 *
 * @param position the position of the drone's feet
 * @param heading the direction of the drone's nose [degrees], from -180 to 180, clockwise seen from
 *     above; 0 is along the room's x axis
 * @param battery the charge of the battery, from 0 to 100 [%]
 * @param flying whether the drone is airborne
 * @param crashed whether the drone has crashed, even if it has since been put back at its start
 * @param takeoffs the number of takeoffs
 * @param touched the objects that the drone touched in flight or crashed into, each with the time
 *     of contact
 * @param visited the names of the gates that the drone flew through, without duplicates, in the
 *     order of the first passage
 * @param start the position of the drone's start, at which a reset puts the drone
 * @param path the positions of the drone in flight, ten per second, followed by its current
 *     position
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
   * A contact of the drone with an object.
   *
   * @param what the object, in words, such as {@code the front wall}
   * @param seconds the simulated time of the contact
   * @param speed the drone's speed at the contact [cm/s]
   * @param crash whether the drone crashed into the object
   */
  public record Touch(String what, double seconds, double speed, boolean crash) {}

  public DroneTruth {
    touched = List.copyOf(touched);
    visited = List.copyOf(visited);
    path = List.copyOf(path);
  }

  /** Returns the height of the drone's feet above the floor [cm]. */
  public double height() {
    return position.z();
  }

  /** Returns the greatest height of the drone's feet above the floor so far [cm]. */
  public double highest() {
    return path.stream().mapToDouble(Position::z).max().orElse(height());
  }

  /** Returns the greatest horizontal distance of the drone from its start so far [cm]. */
  public double farthest() {
    return path.stream().mapToDouble(start::levelDistanceTo).max().orElse(0);
  }

  /** Returns whether the drone has flown and now stands undamaged with its motors off. */
  public boolean landed() {
    return takeoffs > 0 && !flying && !crashed;
  }
}
