package tellosimulator.view.world;

import tellosimulator.math.Attitude;
import tellosimulator.math.Frames;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

/**
 * From where a camera looks at a pivot. Immutable. All angles in radians, all lengths in metres.
 *
 * @param heading along which the camera looks, counter-clockwise seen from above, 0 along x
 * @param elevation how high the camera stands above the pivot, as an angle; negative below it
 * @param distance from the pivot
 * @param shift of the pivot from what is looked at, room frame
 * @param offset of the pivot in the picture
 */
record Orbit(double heading, double elevation, double distance, Vec3 shift, Offset offset) {

  /**
   * Where in the picture the pivot is seen: tangents of the angles from the picture's middle. So
   * panels may cover a side of the picture, and the camera still turns about what one looks at.
   */
  record Offset(double left, double up) {

    static final Offset NONE = new Offset(0, 0);

    private Offset towards(Offset other, double part) {
      return new Offset(left + (other.left - left) * part, up + (other.up - up) * part);
    }
  }

  /** Straight down is 90 degrees; from there on the picture would turn over. */
  static final double HIGHEST = Math.toRadians(89.5);

  /** Decided: a drone that flies high can be seen from below. */
  static final double LOWEST = Math.toRadians(-60);

  /** Nearest distance [m]. Decided: a drone fills the picture. */
  static final double NEAREST = 0.15;

  /** Lowest camera above the floor [m]. Decided. */
  static final double ABOVE_FLOOR = 0.04;

  Orbit {
    elevation = Math.max(LOWEST, Math.min(HIGHEST, elevation));
    distance = Math.max(NEAREST, distance);
  }

  /** With the pivot in the middle of the picture. */
  Orbit(double heading, double elevation, double distance, Vec3 shift) {
    this(heading, elevation, distance, shift, Offset.NONE);
  }

  /** The orbit of a camera that looks along another one's direction, about a pivot. */
  Orbit seenFrom(Vec3 place, Vec3 pivot) {
    Vec3 way = attitude().toBody(pivot.minus(place));
    Offset seen = new Offset(way.y() / way.x(), way.z() / way.x());
    return new Orbit(heading, elevation, way.x(), pivot, seen);
  }

  /** The same about another pivot. */
  Orbit about(Vec3 newShift) {
    return new Orbit(heading, elevation, distance, newShift, offset);
  }

  /** The same with the pivot elsewhere in the picture. */
  Orbit seenAt(Offset newOffset) {
    return new Orbit(heading, elevation, distance, shift, newOffset);
  }

  Orbit turned(double headingChange, double elevationChange) {
    return new Orbit(heading + headingChange, elevation + elevationChange, distance, shift, offset);
  }

  /**
   * Nearer or farther.
   *
   * @param factor of the distance
   * @param farthest limit of the distance [m]
   */
  Orbit zoomed(double factor, double farthest) {
    return new Orbit(heading, elevation, Math.min(farthest, distance * factor), shift, offset);
  }

  /**
   * The pivot moved in the plane of the picture.
   *
   * @param right metres
   * @param up metres
   * @param farthest limit of the shift [m]
   */
  Orbit shifted(double right, double up, double farthest) {
    Vec3 change = attitude().toRoom(new Vec3(0, -right, up));
    return about(shift.plus(change).limitedTo(farthest));
  }

  /**
   * An orbit on the way to another one; turns the shorter way round.
   *
   * @param part of the way, 0 to 1
   */
  Orbit towards(Orbit other, double part) {
    return new Orbit(
        heading + Frames.wrapped(other.heading - heading) * part,
        elevation + (other.elevation - elevation) * part,
        distance * Math.pow(other.distance / distance, part),
        shift.plusScaled(other.shift.minus(shift), part),
        offset.towards(other.offset, part));
  }

  /** The camera's place and direction: it looks along its x axis. Never below the floor. */
  Pose pose(Vec3 target) {
    Vec3 pivot = pivot(target);
    double reach = distance * Math.hypot(1, offset.up());
    double lowest = Math.asin(Math.max(-1, Math.min(1, (ABOVE_FLOOR - pivot.z()) / reach)));
    Attitude attitude = attitude(Math.max(elevation, lowest + Math.atan(offset.up())));
    Vec3 way = new Vec3(1, offset.left(), offset.up()).times(distance);
    return new Pose(pivot.minus(attitude.toRoom(way)), attitude);
  }

  /** What the camera looks at; never below the floor. */
  Vec3 pivot(Vec3 target) {
    Vec3 pivot = target.plus(shift);
    return pivot.withZ(Math.max(0, pivot.z()));
  }

  /** Looks along the heading, and down by the elevation. */
  Attitude attitude() {
    return attitude(elevation);
  }

  private Attitude attitude(double down) {
    Attitude tilt = new Attitude(Math.cos(down / 2), 0, Math.sin(down / 2), 0);
    return Attitude.ofHeading(heading).after(tilt);
  }
}
