package tellosimulator.world;

import java.util.List;
import java.util.Optional;
import tellosimulator.math.Attitude;
import tellosimulator.math.Vec3;

/**
 * A part of an obstacle that is simple enough for collision tests: a box, a cylinder or a torus.
 * All positions and directions are in the room frame. Immutable.
 */
sealed interface Solid permits UprightSolid, Torus {

  /** Returns the bounding box of the solid. */
  Bounds bounds();

  /**
   * Returns the penetration of a collider into the solid; empty if they do not overlap.
   *
   * @param position the collider's position [m]
   * @param before the collider's previous position [m]
   */
  Optional<Penetration> penetration(Vec3 position, Vec3 before, Collider collider);

  /**
   * Returns the distance along a ray to the solid's surface [m]; infinite if the ray misses the
   * solid.
   *
   * @param direction a unit vector
   */
  double distance(Vec3 origin, Vec3 direction);

  /** Whether this solid and another one share more than a surface. */
  boolean overlaps(Solid other);

  /**
   * A displacement that moves a collider out of a solid.
   *
   * @param normal its direction, a unit vector
   * @param depth its length [m]; 0 or less if the collider is already outside
   */
  record Penetration(Vec3 normal, double depth) {}

  /** An axis-aligned bounding box in the room frame [m]. */
  record Bounds(Vec3 least, Vec3 most) {

    /** Returns the bounding box with a given middle and half size. */
    static Bounds around(Vec3 middle, Vec3 half) {
      return new Bounds(middle.minus(half), middle.plus(half));
    }

    /** Whether two boxes share a point. */
    boolean meets(Bounds other) {
      return least.x() <= other.most.x()
          && most.x() >= other.least.x()
          && least.y() <= other.most.y()
          && most.y() >= other.least.y()
          && least.z() <= other.most.z()
          && most.z() >= other.least.z();
    }

    /** Returns the bounding box that contains both boxes. */
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

  /** Returns the solids of an obstacle. */
  static List<Solid> of(Obstacle obstacle) {
    return obstacle
        .shape()
        .match(
            new Shape.Cases<>(
                box -> List.of(box(obstacle, Vec3.ZERO, box.size())),
                cylinder ->
                    List.of(
                        new UprightSolid.Cylinder(
                            obstacle.foot(), cylinder.radius(), cylinder.height())),
                ring -> ring(obstacle, ring),
                frame ->
                    frame.beams().stream()
                        .map(beam -> box(obstacle, beam.base(), beam.size()))
                        .toList()));
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
   * Returns the solid of a box that is given in an obstacle's frame.
   *
   * @param base the middle of the box's base
   * @param size the depth, width and height of the box
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
