package tellosimulator.scenery.orbit;

import tellosimulator.math.Attitude;
import tellosimulator.math.Frames;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

/**
 * The position of a camera relative to the pivot at which it looks. Immutable. All angles are in
 * radians, and all lengths in metres.
 *
 * @param heading the direction in which the camera looks, counter-clockwise seen from above, 0
 *     along x
 * @param elevation the angle of the camera above the pivot; negative below it
 * @param distance the distance of the camera from the pivot
 * @param shift the vector from the target (the followed point or the room's origin) to the pivot,
 *     in the room frame
 * @param offset the position of the pivot in the view
 */
public record Orbit(double heading, double elevation, double distance, Vec3 shift, Offset offset) {

  /**
   * The position of the pivot in the view, as tangents of the angles from the view's middle. An
   * offset lets the camera rotate about the visible centre even if panels cover a side of the view.
   */
  public record Offset(double left, double up) {

    public static final Offset NONE = new Offset(0, 0);

    private Offset towards(Offset other, double part) {
      return new Offset(left + (other.left - left) * part, up + (other.up - up) * part);
    }
  }

  /** Highest elevation. Straight down is 90 degrees, beyond which the view would flip. */
  public static final double HIGHEST = Math.toRadians(89.5);

  /** Lowest elevation. Decided: lets a high-flying drone be seen from below. */
  public static final double LOWEST = Math.toRadians(-60);

  /** Shortest distance [m]. Decided: a drone then fills the view. */
  public static final double NEAREST = 0.15;

  /** Minimum height of the camera above the floor [m]. Decided. */
  public static final double ABOVE_FLOOR = 0.04;

  public Orbit {
    elevation = Math.max(LOWEST, Math.min(HIGHEST, elevation));
    distance = Math.max(NEAREST, distance);
  }

  /** Creates an orbit whose pivot is in the middle of the view. */
  public Orbit(double heading, double elevation, double distance, Vec3 shift) {
    this(heading, elevation, distance, shift, Offset.NONE);
  }

  /**
   * Returns the orbit of a camera at another place, about another pivot. The camera looks in the
   * same direction as in this orbit.
   */
  public Orbit seenFrom(Vec3 place, Vec3 pivot) {
    Vec3 way = attitude().toBody(pivot.minus(place));
    Offset seen = new Offset(way.y() / way.x(), way.z() / way.x());
    return new Orbit(heading, elevation, way.x(), pivot, seen);
  }

  /** Returns this orbit with another shift of the pivot from the target [m]. */
  public Orbit about(Vec3 newShift) {
    return new Orbit(heading, elevation, distance, newShift, offset);
  }

  /** Returns this orbit with the pivot elsewhere in the view. */
  public Orbit seenAt(Offset newOffset) {
    return new Orbit(heading, elevation, distance, shift, newOffset);
  }

  public Orbit turned(double headingChange, double elevationChange) {
    return new Orbit(heading + headingChange, elevation + elevationChange, distance, shift, offset);
  }

  /**
   * Returns this orbit with another distance from the pivot.
   *
   * @param factor the factor by which the distance is multiplied
   * @param farthest the maximum distance [m]
   */
  public Orbit zoomed(double factor, double farthest) {
    return new Orbit(heading, elevation, Math.min(farthest, distance * factor), shift, offset);
  }

  /**
   * Returns this orbit with the pivot moved in the plane of the view.
   *
   * @param right the distance to the right [m]
   * @param up the distance upwards [m]
   * @param farthest the maximum shift [m]
   */
  public Orbit shifted(double right, double up, double farthest) {
    Vec3 change = attitude().toRoom(new Vec3(0, -right, up));
    return about(shift.plus(change).limitedTo(farthest));
  }

  /**
   * Interpolates between this orbit and another one. The camera rotates the shorter way.
   *
   * @param part the fraction of the way, 0 to 1
   */
  public Orbit towards(Orbit other, double part) {
    return new Orbit(
        heading + Frames.wrapped(other.heading - heading) * part,
        elevation + (other.elevation - elevation) * part,
        distance * StrictMath.pow(other.distance / distance, part),
        shift.plusScaled(other.shift.minus(shift), part),
        offset.towards(other.offset, part));
  }

  /**
   * Returns the pose of the camera in the room frame. The camera looks along its x axis, and is
   * never below the floor.
   *
   * @param target the followed point or the room's origin, in the room frame [m]
   */
  public Pose pose(Vec3 target) {
    Vec3 pivot = pivot(target);
    double reach = distance * StrictMath.hypot(1, offset.up());
    double lowest = StrictMath.asin(Math.max(-1, Math.min(1, (ABOVE_FLOOR - pivot.z()) / reach)));
    Attitude attitude = attitude(Math.max(elevation, lowest + StrictMath.atan(offset.up())));
    Vec3 way = new Vec3(1, offset.left(), offset.up()).times(distance);
    return new Pose(pivot.minus(attitude.toRoom(way)), attitude);
  }

  /** Returns the point that the camera looks at; never below the floor. */
  public Vec3 pivot(Vec3 target) {
    Vec3 pivot = target.plus(shift);
    return pivot.withZ(Math.max(0, pivot.z()));
  }

  /** Returns the camera's attitude: along the heading, tilted down by the elevation. */
  public Attitude attitude() {
    return attitude(elevation);
  }

  private Attitude attitude(double down) {
    Attitude tilt = new Attitude(StrictMath.cos(down / 2), 0, StrictMath.sin(down / 2), 0);
    return Attitude.ofHeading(heading).after(tilt);
  }
}
