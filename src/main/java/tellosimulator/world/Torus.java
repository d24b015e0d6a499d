package tellosimulator.world;

import java.util.List;
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
record Torus(Vec3 middle, double radius, double tube, Vec3 ahead) implements Solid {

  /** A ray that is this near to the tube has reached it [m]. Decided. */
  private static final double REACHED = 1e-4;

  /** Farthest that a ray is followed [m]: through the longest room from corner to corner. */
  private static final double FARTHEST = 3 * Room.LONGEST;

  private static final int MOST_STEPS = 200;

  /** How often the nearest points of collider and ring are looked for in turn. Decided: to a mm. */
  private static final int MOST_TURNS = 6;

  @Override
  public Bounds bounds() {
    double out = radius + tube;
    double x = Math.abs(ahead.y()) * out + Math.abs(ahead.x()) * tube;
    double y = Math.abs(ahead.x()) * out + Math.abs(ahead.y()) * tube;
    return Bounds.around(middle, new Vec3(x, y, out));
  }

  /** The way out of that piece of the tube which reaches farthest into the collider. */
  @Override
  public Optional<Penetration> penetration(Vec3 position, Vec3 before, Collider collider) {
    Vec3 across = new Vec3(-ahead.y(), ahead.x(), 0).times(collider.radius());
    Vec3 middle = middleOf(position, collider);
    Vec3 away = between(middle, position, collider);
    for (Vec3 side : List.of(middle.plus(across), middle.minus(across))) {
      Vec3 there = between(side, position, collider);
      away = there.norm() < away.norm() ? there : away;
    }
    double distance = away.norm();
    if (distance >= tube) {
      return Optional.empty();
    }
    return Optional.of(
        distance < REACHED
            ? deep(position, collider)
            : new Penetration(away.times(1 / distance), tube - distance));
  }

  /**
   * From the ring to the collider where they are nearest, looked for around a place in the
   * collider.
   */
  private Vec3 between(Vec3 start, Vec3 position, Collider collider) {
    Vec3 onRing = nearest(start);
    Vec3 onHull = start;
    for (int i = 0; i < MOST_TURNS; i++) {
      onHull = collider.nearest(position, onRing);
      onRing = nearest(onHull);
    }
    return onHull.minus(onRing);
  }

  /**
   * For a collider that the middle of the tube is in: away from there, as far as the collider
   * reaches.
   */
  private Penetration deep(Vec3 position, Collider collider) {
    Vec3 center = middleOf(position, collider);
    Vec3 away = center.minus(nearest(center));
    double distance = away.norm();
    Vec3 normal = distance == 0 ? ahead : away.times(1 / distance);
    double reach =
        collider.radius() * normal.horizontal().norm()
            + collider.height() / 2 * Math.abs(normal.z());
    return new Penetration(normal, tube + reach - distance);
  }

  private static Vec3 middleOf(Vec3 position, Collider collider) {
    return position.plusScaled(Vec3.UP, collider.height() / 2);
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
