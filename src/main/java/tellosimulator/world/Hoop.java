package tellosimulator.world;

import java.util.Optional;
import tellosimulator.math.Vec3;

/**
 * An upright ring: a torus.
 *
 * @param middle of the opening, room frame [m]
 * @param radius from the middle to the middle of the tube [m]
 * @param tube radius of the tube [m]
 * @param ahead unit vector through the opening, level
 */
record Hoop(Vec3 middle, double radius, double tube, Vec3 ahead) implements Solid {

  /** A ray that is this near to the tube has reached it [m]. Decided. */
  private static final double REACHED = 1e-4;

  /** Farthest that a ray is followed [m]: through the longest room from corner to corner. */
  private static final double FARTHEST = 3 * Room.LONGEST;

  private static final int MOST_STEPS = 200;

  @Override
  public Bounds bounds() {
    double out = radius + tube;
    double x = Math.abs(ahead.y()) * out + Math.abs(ahead.x()) * tube;
    double y = Math.abs(ahead.x()) * out + Math.abs(ahead.y()) * tube;
    return Bounds.around(middle, new Vec3(x, y, out));
  }

  /**
   * The way out of the nearest piece of the tube, as if it were straight: on a ring that a drone
   * can fly through the difference is less than a centimetre.
   */
  @Override
  public Optional<Exit> exit(Vec3 position, Vec3 before, Hull hull) {
    Vec3 centre = position.plusScaled(Vec3.UP, hull.height() / 2);
    Vec3 away = centre.minus(nearest(centre));
    double distance = away.norm();
    if (distance == 0) {
      return Optional.of(new Exit(ahead, tube + hull.radius()));
    }
    Vec3 normal = away.times(1 / distance);
    double reach =
        hull.radius() * normal.horizontal().norm() + hull.height() / 2 * Math.abs(normal.z());
    double depth = tube + reach - distance;
    return depth > 0 ? Optional.of(new Exit(normal, depth)) : Optional.empty();
  }

  /** Goes along the ray as far as nothing can be in the way, again and again. */
  @Override
  public double distance(Vec3 origin, Vec3 direction) {
    double gone = 0;
    for (int i = 0; i < MOST_STEPS && gone < FARTHEST; i++) {
      Vec3 point = origin.plusScaled(direction, gone);
      double free = point.distanceTo(nearest(point)) - tube;
      if (free < REACHED) {
        return gone;
      }
      gone += free;
    }
    return Double.POSITIVE_INFINITY;
  }

  /** The nearest point in the middle of the tube. */
  private Vec3 nearest(Vec3 point) {
    Vec3 offset = point.minus(middle);
    Vec3 inPlane = offset.plusScaled(ahead, -offset.dot(ahead));
    double norm = inPlane.norm();
    Vec3 spoke = norm == 0 ? Vec3.UP : inPlane.times(1 / norm);
    return middle.plusScaled(spoke, radius);
  }
}
