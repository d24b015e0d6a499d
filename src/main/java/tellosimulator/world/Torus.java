package tellosimulator.world;

import java.util.List;
import java.util.Optional;
import tellosimulator.math.Vec3;

/**
 * An upright torus.
 *
 * @param middle the middle of the opening, in the room frame [m]
 * @param radius the distance from the middle of the opening to the centre line of the tube [m]
 * @param tube the radius of the tube [m]
 * @param ahead a horizontal unit vector along the axis of the torus
 */
record Torus(Vec3 middle, double radius, double tube, Vec3 ahead) implements Solid {

  /** Distance from the tube at which a ray counts as having reached it [m]. Decided. */
  private static final double REACHED = 1e-4;

  /** Maximum length of a ray [m]: longer than the diagonal of the largest room. */
  private static final double FARTHEST = 3 * Room.LONGEST;

  private static final int MOST_STEPS = 200;

  /** Number of pieces of the tube that are tested for overlaps. Decided: 7 cm apart for 1.5 m. */
  private static final int PIECES = 64;

  /**
   * Number of iterations in the search for the shortest vector between the collider and the tube's
   * centre line. Decided: the result is accurate to 1 mm.
   */
  private static final int MOST_TURNS = 6;

  @Override
  public Bounds bounds() {
    double out = radius + tube;
    double x = Math.abs(ahead.y()) * out + Math.abs(ahead.x()) * tube;
    double y = Math.abs(ahead.x()) * out + Math.abs(ahead.y()) * tube;
    return Bounds.around(middle, new Vec3(x, y, out));
  }

  /** Returns the shortest displacement that moves the collider out of the tube. */
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
   * Returns the shortest vector from the centre line of the tube to the collider. The search starts
   * at {@code start}, a point in the collider.
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
   * Returns the penetration of a collider that contains a point of the tube's centre line. The
   * collider is pushed away from the point of the centre line that is nearest to the collider's
   * middle, until the collider is clear of the tube.
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

  /** Tests short upright cylinders that are as thick as the tube, all around it. */
  @Override
  public boolean overlaps(Solid other) {
    Collider piece = new Collider(tube, 2 * tube);
    Vec3 across = new Vec3(-ahead.y(), ahead.x(), 0);
    for (int i = 0; i < PIECES; i++) {
      double angle = 2 * Math.PI * i / PIECES;
      Vec3 foot =
          middle
              .plusScaled(across, radius * StrictMath.cos(angle))
              .plusScaled(Vec3.UP, radius * StrictMath.sin(angle) - tube);
      if (other.penetration(foot, foot, piece).isPresent()) {
        return true;
      }
    }
    return false;
  }

  private static Vec3 middleOf(Vec3 position, Collider collider) {
    return position.plusScaled(Vec3.UP, collider.height() / 2);
  }

  /** Follows a ray in steps no longer than the distance to the tube (sphere tracing). */
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

  /** Returns the point on the centre line of the tube that is nearest to {@code point}. */
  private Vec3 nearest(Vec3 point) {
    Vec3 offset = point.minus(middle);
    Vec3 inPlane = offset.plusScaled(ahead, -offset.dot(ahead));
    double norm = inPlane.norm();
    Vec3 spoke = norm == 0 ? Vec3.UP : inPlane.times(1 / norm);
    return middle.plusScaled(spoke, radius);
  }
}
