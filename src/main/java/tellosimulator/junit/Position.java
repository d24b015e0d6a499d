package tellosimulator.junit;

import java.util.Locale;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;

/**
 * A position in the room [cm]: x along the room's depth, y to the left, z up. The origin is the
 * middle of the floor. The position of a drone is that of its feet. Immutable.
 */
public record Position(double x, double y, double z) {

  static Position of(Vec3 place) {
    return new Position(
        Frames.centimeters(place.x()),
        Frames.centimeters(place.y()),
        Frames.centimeters(place.z()));
  }

  /** Returns the straight-line distance to another position [cm]. */
  public double distanceTo(Position other) {
    return Math.hypot(levelDistanceTo(other), z - other.z);
  }

  /** Returns the horizontal distance to another position [cm]. */
  public double levelDistanceTo(Position other) {
    return Math.hypot(x - other.x, y - other.y);
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT, "x %d, y %d, z %d cm", Math.round(x), Math.round(y), Math.round(z));
  }
}
