package tellosimulator.world;

import java.util.List;
import java.util.Optional;
import tellosimulator.math.Attitude;
import tellosimulator.math.Vec3;

/** A convex or round part of an obstacle, simple enough to collide with. Room frame. Immutable. */
sealed interface Solid permits UprightSolid, Torus {

  /** The box around it. */
  Bounds bounds();

  /**
   * How deep a collider is in it; empty if it is not in it.
   *
   * @param position where the collider is [m]
   * @param before where it came from [m]
   */
  Optional<Penetration> penetration(Vec3 position, Vec3 before, Collider collider);

  /**
   * Distance along a ray to its surface [m]; infinite if the ray misses it.
   *
   * @param direction unit vector
   */
  double distance(Vec3 origin, Vec3 direction);

  /**
   * The shortest way out of a solid.
   *
   * @param normal unit vector
   * @param depth metres, above 0
   */
  record Penetration(Vec3 normal, double depth) {}

  /** An axis-aligned bounding box of the room frame [m]. */
  record Bounds(Vec3 least, Vec3 most) {

    /** Around a middle. */
    static Bounds around(Vec3 middle, Vec3 half) {
      return new Bounds(middle.minus(half), middle.plus(half));
    }

    /** Whether they share a point. */
    boolean meets(Bounds other) {
      return least.x() <= other.most.x()
          && most.x() >= other.least.x()
          && least.y() <= other.most.y()
          && most.y() >= other.least.y()
          && least.z() <= other.most.z()
          && most.z() >= other.least.z();
    }

    /** Around both. */
    Bounds with(Bounds other) {
      return new Bounds(
          new Vec3(
              Math.min(least.x(), other.least.x()),
              Math.min(least.y(), other.least.y()),
              Math.min(least.z(), other.least.z())),
          new Vec3(
              Math.max(most.x(), other.most.x()),
              Math.max(most.y(), other.most.y()),
              Math.max(most.z(), other.most.z())));
    }
  }

  /** The solids of which an obstacle is made. */
  static List<Solid> of(Obstacle obstacle) {
    Shape shape = obstacle.shape();
    if (shape instanceof Shape.Box box) {
      return List.of(box(obstacle, Vec3.ZERO, new Vec3(box.depth(), box.width(), box.height())));
    }
    if (shape instanceof Shape.Cylinder cylinder) {
      return List.of(
          new UprightSolid.Cylinder(obstacle.foot(), cylinder.radius(), cylinder.height()));
    }
    if (shape instanceof Shape.Ring ring) {
      return ring(obstacle, ring);
    }
    return ((Shape.Frame) shape)
        .beams().stream().map(beam -> box(obstacle, beam.base(), beam.size())).toList();
  }

  private static List<Solid> ring(Obstacle obstacle, Shape.Ring ring) {
    double tube = ring.tube() / 2;
    Solid torus =
        new Torus(
            obstacle.foot().plusScaled(Vec3.UP, ring.middle()),
            ring.radius() + tube,
            tube,
            ahead(obstacle));
    return ring.post() == 0
        ? List.of(torus)
        : List.of(torus, new UprightSolid.Cylinder(obstacle.foot(), tube, ring.post()));
  }

  /**
   * A box in an obstacle's frame.
   *
   * @param base middle of its base
   * @param size its depth, width and height
   */
  private static Solid box(Obstacle obstacle, Vec3 base, Vec3 size) {
    return new UprightSolid.Box(
        obstacle.foot().plus(obstacle.pose().attitude().toRoom(base)),
        new Vec3(size.x() / 2, size.y() / 2, size.z()),
        ahead(obstacle));
  }

  private static Vec3 ahead(Obstacle obstacle) {
    return Attitude.ofHeading(obstacle.heading()).toRoom(new Vec3(1, 0, 0));
  }
}
