package tellosimulator.scenery.overlay;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Vec3;

/**
 * A flown path that consists of a limited number of points. A straight section needs only two
 * points. When the path is full, every second point is dropped. Not thread-safe.
 */
final class FlightPath {

  /** Minimum distance between successive points [m]. Decided: too small to be visible. */
  static final double SPACING = 0.02;

  /** Maximum deviation of a dropped point from the path [m]. Decided: too small to be visible. */
  private static final double STRAIGHT = 0.002;

  /** Number of sides of the tube that displays the path. */
  static final int SIDES = 3;

  private final int capacity;
  private final List<Vec3> points = new ArrayList<>();

  /**
   * Creates an empty path.
   *
   * @param capacity maximum number of points, at least 4
   */
  FlightPath(int capacity) {
    this.capacity = capacity;
  }

  /**
   * Extends the path to the drone's new position.
   *
   * @return whether the path has changed
   */
  boolean add(Vec3 point) {
    int size = points.size();
    if (size > 0 && points.get(size - 1).distanceTo(point) < SPACING) {
      return false;
    }
    if (size >= 2 && isStraight(points.get(size - 2), points.get(size - 1), point)) {
      points.set(size - 1, point);
      return true;
    }
    if (size == capacity) {
      thinOut();
    }
    points.add(point);
    return true;
  }

  void clear() {
    points.clear();
  }

  int size() {
    return points.size();
  }

  Vec3 point(int index) {
    return points.get(index);
  }

  /** Returns the cross-section of a tube along the path, at one of its points. */
  List<Vec3> ring(int index, LineWidth width) {
    Vec3 point = points.get(index);
    Vec3 next = points.get(Math.min(points.size() - 1, index + 1));
    Vec3 way = next.minus(points.get(Math.max(0, index - 1)));
    Vec3 reference = Math.abs(way.z()) > 0.9 * way.norm() ? new Vec3(1, 0, 0) : Vec3.UP;
    Vec3 side = way.cross(reference).normalized().times(width.half(point));
    Vec3 up = side.cross(way).normalized().times(width.half(point));
    return List.of(
        point.plus(up),
        point.plus(side).plusScaled(up, -0.5),
        point.minus(side).plusScaled(up, -0.5));
  }

  /**
   * Returns whether a tube that was built for one camera position also looks right from another
   * camera position.
   *
   * @param made thickness for which the tube was built
   * @param wanted thickness for the other camera position
   */
  boolean looksRight(LineWidth made, LineWidth wanted) {
    return points.stream().allMatch(point -> made.suits(wanted, point));
  }

  /**
   * Returns whether a point can be dropped because it lies on a straight line between two others.
   */
  private static boolean isStraight(Vec3 from, Vec3 middle, Vec3 to) {
    Vec3 way = to.minus(from);
    Vec3 part = middle.minus(from);
    double length = way.norm();
    double along = part.dot(way) / length;
    boolean onward = along > 0 && along < length;
    return onward && part.cross(way).norm() / length < STRAIGHT / 4 && length < 1;
  }

  /** Drops every second point except the first and the last one. */
  private void thinOut() {
    List<Vec3> kept = new ArrayList<>();
    for (int i = 0; i < points.size() - 1; i += 2) {
      kept.add(points.get(i));
    }
    kept.add(points.get(points.size() - 1));
    points.clear();
    points.addAll(kept);
  }
}
