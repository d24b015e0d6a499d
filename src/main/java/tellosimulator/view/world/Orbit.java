package tellosimulator.view.world;

import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

/**
 * From where a camera looks at a pivot. Immutable. All angles in radians, all lengths in metres.
 *
 * @param heading along which the camera looks, counter-clockwise seen from above, 0 along x
 * @param elevation how high the camera stands above the pivot, as an angle; negative below it
 * @param distance from the pivot
 * @param shift of the pivot from what is looked at, room frame
 */
record Orbit(double heading, double elevation, double distance, Vec3 shift) {

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

  Orbit turned(double headingChange, double elevationChange) {
    return new Orbit(heading + headingChange, elevation + elevationChange, distance, shift);
  }

  /**
   * Nearer or farther.
   *
   * @param factor of the distance
   * @param farthest limit of the distance [m]
   */
  Orbit zoomed(double factor, double farthest) {
    return new Orbit(heading, elevation, Math.min(farthest, distance * factor), shift);
  }

  /**
   * The pivot moved in the plane of the picture.
   *
   * @param right metres
   * @param up metres
   * @param farthest limit of the shift [m]
   */
  Orbit shifted(double right, double up, double farthest) {
    Attitude attitude = attitude(elevation);
    Vec3 change = attitude.toRoom(new Vec3(0, -right, up));
    return new Orbit(heading, elevation, distance, shift.plus(change).limitedTo(farthest));
  }

  /** The camera's place and direction: its x axis leads to the pivot. Never below the floor. */
  Pose pose(Vec3 target) {
    Vec3 pivot = pivot(target);
    double lowest = Math.asin(Math.max(-1, Math.min(1, (ABOVE_FLOOR - pivot.z()) / distance)));
    Attitude attitude = attitude(Math.max(elevation, lowest));
    return new Pose(pivot.minus(attitude.toRoom(new Vec3(distance, 0, 0))), attitude);
  }

  /** What the camera looks at; never below the floor. */
  Vec3 pivot(Vec3 target) {
    Vec3 pivot = target.plus(shift);
    return pivot.withZ(Math.max(0, pivot.z()));
  }

  /** Looks along the heading, and down by the elevation. */
  private Attitude attitude(double down) {
    Attitude tilt = new Attitude(Math.cos(down / 2), 0, Math.sin(down / 2), 0);
    return Attitude.ofHeading(heading).after(tilt);
  }
}
