package tellosimulator.junit;

import java.util.Locale;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;

/**
 * A place in the room [cm]: x along its depth, y to the left, z up, from the middle of the floor. A
 * drone is where its feet are. Immutable.
 */
public record Position(double x, double y, double z) {

  static Position of(Vec3 place) {
    return new Position(
        Frames.centimeters(place.x()),
        Frames.centimeters(place.y()),
        Frames.centimeters(place.z()));
  }

  /** Straight to another place [cm]. */
  public double distanceTo(Position other) {
    return Math.hypot(levelDistanceTo(other), z - other.z);
  }

  /** To the point over or under another place [cm]. */
  public double levelDistanceTo(Position other) {
    return Math.hypot(x - other.x, y - other.y);
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT, "x %d, y %d, z %d cm", Math.round(x), Math.round(y), Math.round(z));
  }
}
