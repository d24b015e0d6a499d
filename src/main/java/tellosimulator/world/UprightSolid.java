package tellosimulator.world;

import java.util.Optional;
import tellosimulator.math.Vec3;

/**
 * A solid with vertical sides and horizontal ends. A collider is pushed out sideways, upwards or
 * downwards, depending on how it entered.
 */
sealed interface UprightSolid extends Solid {

  /**
   * Tolerance in deciding whether a collider was above the top or below the base [m]. Decided: it
   * covers rounding errors.
   */
  double TOUCHING = 1e-9;

  /** Depth of an overlap that still counts as contact [m]. Decided: it covers rounding errors. */
  double CONTACT = 1e-3;

  /** Returns the middle of the solid's base. */
  Vec3 middle();

  /** Returns the height of the solid's upper end [m]. */
  double top();

  /**
   * Returns the shortest horizontal way out of the solid for an upright cylinder. The depth is 0 or
   * less if the cylinder is beside the solid.
   *
   * @param position the middle of the cylinder's base [m]
   * @param radius the cylinder's radius [m]
   */
  Penetration sidewards(Vec3 position, double radius);

  @Override
  default Optional<Penetration> penetration(Vec3 position, Vec3 before, Collider collider) {
    double bottom = middle().z();
    Penetration sidewards = sidewards(position, collider.radius());
    double over = top() - position.z();
    double under = position.z() + collider.height() - bottom;
    if (over <= 0 || under <= 0 || sidewards.depth() <= 0) {
      return Optional.empty();
    }
    if (sidewards(before, collider.radius()).depth() <= 0) {
      return Optional.of(sidewards);
    }
    Penetration upwards = new Penetration(Vec3.UP, over);
    Penetration downwards = new Penetration(Vec3.UP.times(-1), under);
    if (before.z() >= top() - TOUCHING) {
      return Optional.of(upwards);
    }
    if (before.z() + collider.height() <= bottom + TOUCHING) {
      return Optional.of(downwards);
    }
    boolean passable = bottom >= collider.height(); // otherwise, the collider does not fit below
    double down = passable ? under : Double.POSITIVE_INFINITY;
    if (sidewards.depth() <= Math.min(over, down)) {
      return Optional.of(sidewards);
    }
    return Optional.of(over <= down ? upwards : downwards);
  }

  /** Whether the outlines of two solids, seen from above, share more than an edge. */
  boolean covers(UprightSolid other);

  @Override
  default boolean overlaps(Solid other) {
    return other instanceof UprightSolid upright
        ? middle().z() < upright.top() - CONTACT
            && upright.middle().z() < top() - CONTACT
            && covers(upright)
        : other.overlaps(this);
  }

  /** The part of a ray that is inside a solid; empty if {@code in} is greater than {@code out}. */
  record Interval(double in, double out) {

    private static final Interval EVERYWHERE =
        new Interval(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
    private static final Interval NOWHERE =
        new Interval(Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY);

    /** Returns the interval in which a coordinate of a ray is between two values. */
    static Interval between(double least, double most, double origin, double direction) {
      if (direction == 0) {
        return origin >= least && origin <= most ? EVERYWHERE : NOWHERE;
      }
      double a = (least - origin) / direction;
      double b = (most - origin) / direction;
      return new Interval(Math.min(a, b), Math.max(a, b));
    }

    Interval and(Interval other) {
      return new Interval(Math.max(in, other.in), Math.min(out, other.out));
    }

    /**
     * Returns the distance at which the ray enters: 0 if the ray begins inside, infinite if it
     * never enters.
     */
    double entry() {
      return in > out || out < 0 ? Double.POSITIVE_INFINITY : Math.max(0, in);
    }
  }

  /**
   * A box.
   *
   * @param half half the depth (x), half the width (y) and the full height (z) [m]
   * @param ahead the horizontal unit vector along the box's x axis
   */
  record Box(Vec3 middle, Vec3 half, Vec3 ahead) implements UprightSolid {

    @Override
    public double top() {
      return middle.z() + half.z();
    }

    @Override
    public Bounds bounds() {
      double x = Math.abs(ahead.x()) * half.x() + Math.abs(ahead.y()) * half.y();
      double y = Math.abs(ahead.y()) * half.x() + Math.abs(ahead.x()) * half.y();
      return new Bounds(middle.minus(new Vec3(x, y, 0)), middle.plus(new Vec3(x, y, half.z())));
    }

    @Override
    public Penetration sidewards(Vec3 position, double radius) {
      Vec3 local = local(position.minus(middle));
      double beyondX = Math.abs(local.x()) - half.x();
      double beyondY = Math.abs(local.y()) - half.y();
      double signX = local.x() < 0 ? -1 : 1;
      double signY = local.y() < 0 ? -1 : 1;
      if (beyondX > 0 && beyondY > 0) {
        double beyond = Math.sqrt(beyondX * beyondX + beyondY * beyondY);
        Vec3 corner = new Vec3(signX * beyondX / beyond, signY * beyondY / beyond, 0);
        return new Penetration(room(corner), radius - beyond);
      }
      return beyondX > beyondY
          ? new Penetration(room(new Vec3(signX, 0, 0)), radius - beyondX)
          : new Penetration(room(new Vec3(0, signY, 0)), radius - beyondY);
    }

    @Override
    public boolean covers(UprightSolid other) {
      return other instanceof Box box ? !isBeside(box) && !box.isBeside(this) : other.covers(this);
    }

    /** Whether an axis of this box separates it from another box, seen from above. */
    private boolean isBeside(Box other) {
      Vec3 between = local(other.middle.minus(middle));
      Vec3 otherAhead = local(other.ahead);
      double cosine = Math.abs(otherAhead.x());
      double sine = Math.abs(otherAhead.y());
      double alongX = half.x() + cosine * other.half.x() + sine * other.half.y();
      double alongY = half.y() + sine * other.half.x() + cosine * other.half.y();
      return Math.abs(between.x()) > alongX - CONTACT || Math.abs(between.y()) > alongY - CONTACT;
    }

    @Override
    public double distance(Vec3 origin, Vec3 direction) {
      Vec3 from = local(origin.minus(middle));
      Vec3 along = local(direction);
      return Interval.between(middle.z(), top(), origin.z(), direction.z())
          .and(Interval.between(-half.x(), half.x(), from.x(), along.x()))
          .and(Interval.between(-half.y(), half.y(), from.y(), along.y()))
          .entry();
    }

    private Vec3 local(Vec3 vector) {
      return new Vec3(
          vector.x() * ahead.x() + vector.y() * ahead.y(),
          vector.y() * ahead.x() - vector.x() * ahead.y(),
          vector.z());
    }

    private Vec3 room(Vec3 vector) {
      return new Vec3(
          vector.x() * ahead.x() - vector.y() * ahead.y(),
          vector.x() * ahead.y() + vector.y() * ahead.x(),
          vector.z());
    }
  }

  /** An upright cylinder. */
  record Cylinder(Vec3 middle, double radius, double height) implements UprightSolid {

    @Override
    public double top() {
      return middle.z() + height;
    }

    @Override
    public Bounds bounds() {
      return new Bounds(
          middle.minus(new Vec3(radius, radius, 0)), middle.plus(new Vec3(radius, radius, height)));
    }

    @Override
    public Penetration sidewards(Vec3 position, double grown) {
      Vec3 spoke = position.minus(middle).horizontal();
      double distance = spoke.norm();
      Vec3 normal = distance == 0 ? new Vec3(1, 0, 0) : spoke.times(1 / distance);
      return new Penetration(normal, radius + grown - distance);
    }

    @Override
    public boolean covers(UprightSolid other) {
      return other.sidewards(middle, radius).depth() > CONTACT;
    }

    @Override
    public double distance(Vec3 origin, Vec3 direction) {
      Interval level = Interval.between(middle.z(), top(), origin.z(), direction.z());
      Vec3 from = origin.minus(middle).horizontal();
      Vec3 along = direction.horizontal();
      double a = along.dot(along);
      double c = from.dot(from) - radius * radius;
      if (a == 0) {
        return c <= 0 ? level.entry() : Double.POSITIVE_INFINITY;
      }
      double b = from.dot(along);
      double root = b * b - a * c;
      if (root < 0) {
        return Double.POSITIVE_INFINITY;
      }
      double half = Math.sqrt(root);
      return level.and(new Interval((-b - half) / a, (-b + half) / a)).entry();
    }
  }
}
