package tellosimulator.scenery.orbit;

import java.util.List;
import tellosimulator.math.Attitude;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.orbit.Orbit.Offset;

/**
 * A rectangle of a perspective view, given by the tangents of the angles between the middle of the
 * view and the rectangle's edges. Immutable.
 *
 * @param left positive to the left of the middle
 * @param right less than {@code left}
 * @param top positive above the middle
 * @param bottom less than {@code top}
 */
public record ViewWindow(double left, double right, double top, double bottom) {

  /**
   * Returns a rectangle of a view.
   *
   * @param focalLength the focal length of the view [px]
   * @param left distance of the left edge from the middle of the view [px]; the others likewise
   */
  public static ViewWindow of(
      double focalLength, double left, double right, double top, double bottom) {
    return new ViewWindow(
        left / focalLength, right / focalLength, top / focalLength, bottom / focalLength);
  }

  /** Returns the offset of the rectangle's middle. */
  public Offset middle() {
    return new Offset((left + right) / 2, (top + bottom) / 2);
  }

  /**
   * Returns the nearest camera position from which all of the given points are seen in this
   * rectangle. The points then touch two opposite edges. They are centred between left and right,
   * and also between top and bottom if the camera looks straight down. The more level the camera
   * looks, the nearer the points are to the lower edge, because the walls of a room rise above its
   * floor.
   *
   * <p>In the camera's frame, a camera at c sees a point p within the left edge if (p.y − c.y) /
   * (p.x − c.x) is at most {@code left}, so c.y − left c.x must be at least the greatest p.y − left
   * p.x. The four edges together leave an interval for c.y and one for c.z. Both intervals shrink
   * as c.x grows; at the greatest c.x, one of them is a point.
   *
   * @param points at least two points in the room frame [m]
   * @param attitude the attitude of the camera, which looks along its x axis
   */
  public Vec3 nearest(List<Vec3> points, Attitude attitude) {
    double leftmost = Double.NEGATIVE_INFINITY;
    double rightmost = Double.POSITIVE_INFINITY;
    double highest = Double.NEGATIVE_INFINITY;
    double lowest = Double.POSITIVE_INFINITY;
    for (Vec3 point : points) {
      Vec3 seen = attitude.toBody(point);
      leftmost = Math.max(leftmost, seen.y() - left * seen.x());
      rightmost = Math.min(rightmost, seen.y() - right * seen.x());
      highest = Math.max(highest, seen.z() - top * seen.x());
      lowest = Math.min(lowest, seen.z() - bottom * seen.x());
    }
    double x =
        Math.min((rightmost - leftmost) / (left - right), (lowest - highest) / (top - bottom));
    double y = (leftmost + left * x + rightmost + right * x) / 2;
    double ahead = attitude.toRoom(new Vec3(1, 0, 0)).z();
    double low = 1 - ahead * ahead / 2;
    double z = (1 - low) * (highest + top * x) + low * (lowest + bottom * x);
    return attitude.toRoom(new Vec3(x, y, z));
  }
}
