package tellosimulator.world;

import java.util.Optional;
import tellosimulator.math.Vec3;

/** A part of an obstacle that is simple enough to be calculated with. Room frame. Immutable. */
interface Solid {

  /** The upright box around it. */
  Bounds bounds();

  /**
   * How a hull gets out of it; empty if it is not in it.
   *
   * @param position where the hull is [m]
   * @param before where it came from [m]
   */
  Optional<Exit> exit(Vec3 position, Vec3 before, Hull hull);

  /**
   * Distance along a ray to its surface [m]; infinite if the ray misses it.
   *
   * @param direction unit vector
   */
  double distance(Vec3 origin, Vec3 direction);

  /**
   * The shortest way out.
   *
   * @param normal unit vector
   * @param depth metres, above 0
   */
  record Exit(Vec3 normal, double depth) {}

  /** An upright box along the axes of the room [m]. */
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
}
