package tellosimulator.world;

import java.util.Optional;
import java.util.stream.Stream;
import tellosimulator.math.Vec3;

/**
 * A room in the shape of a box. The centre of its floor is the origin of the room frame. Immutable.
 *
 * @param width the extent along y [m]
 * @param depth the extent along x [m]
 * @param height the extent along z [m]
 */
public record Room(double width, double depth, double height) {

  /** The default room. Decided: 5 by 5 by 3 m, as in this simulator's predecessor of 2020. */
  public static final Room DEFAULT = new Room(5, 5, 3);

  /**
   * Minimum length of an edge [m]. Assumed: enough for a drone at its start, with some space around
   * it.
   */
  public static final double SHORTEST = 1;

  /** Maximum length of an edge [m]. Assumed: twice the 100 m that the drone's Wi-Fi reaches. */
  public static final double LONGEST = 200;

  public Room {
    check("width", width);
    check("depth", depth);
    check("height", height);
  }

  /** Whether a collider at {@code position} is entirely inside the room. */
  public boolean contains(Vec3 position, Collider collider) {
    return Math.abs(position.x()) <= depth / 2 - collider.radius()
        && Math.abs(position.y()) <= width / 2 - collider.radius()
        && position.z() >= 0
        && position.z() <= height - collider.height();
  }

  /** Returns the distance from the room's middle to a wall [m]. */
  public double distanceTo(Surface wall) {
    return (alongDepth(wall) ? width : depth) / 2;
  }

  /** Returns the length of a wall, or the width of the floor or the ceiling [m]. */
  public double lengthOf(Surface surface) {
    return alongDepth(surface) ? depth : width;
  }

  private static boolean alongDepth(Surface surface) {
    return surface == Surface.LEFT_WALL || surface == Surface.RIGHT_WALL;
  }

  /**
   * Returns the distance from the start of a ray, inside the room, to the point at which the ray
   * leaves the room [m].
   *
   * @param direction a unit vector
   */
  public double distance(Vec3 origin, Vec3 direction) {
    double level =
        Math.min(
            way(origin.x(), direction.x(), -depth / 2, depth / 2),
            way(origin.y(), direction.y(), -width / 2, width / 2));
    return Math.max(0, Math.min(level, way(origin.z(), direction.z(), 0, height)));
  }

  private static double way(double origin, double direction, double low, double high) {
    if (direction == 0) {
      return Double.POSITIVE_INFINITY;
    }
    return ((direction > 0 ? high : low) - origin) / direction;
  }

  /** Returns the position nearest to {@code position} at which a collider fits. */
  public Vec3 nearestInside(Vec3 position, Collider collider) {
    return new Vec3(
        clamp(position.x(), -(depth / 2 - collider.radius()), depth / 2 - collider.radius()),
        clamp(position.y(), -(width / 2 - collider.radius()), width / 2 - collider.radius()),
        clamp(position.z(), 0, height - collider.height()));
  }

  /**
   * Returns the collision of a body with the surfaces of the room, if any. The body slides along
   * the surface that it touches.
   *
   * @param position the position that the body would reach without a collision [m]
   * @param velocity the velocity [m/s]
   */
  public Optional<Collision> collide(Vec3 position, Vec3 velocity, Collider collider) {
    if (contains(position, collider)) {
      return Optional.empty();
    }
    Vec3 inside = nearestInside(position, collider);
    Vec3 push = inside.minus(position);
    Vec3 left = velocity;
    Hit worst = new Hit(Surface.FLOOR, Vec3.UP, Double.NEGATIVE_INFINITY);
    for (Hit hit : hits(push, velocity)) {
      if (hit.speed > worst.speed) {
        worst = hit;
      }
      if (hit.speed > 0) {
        left = left.plusScaled(hit.normal, hit.speed);
      }
    }
    return Optional.of(
        new Collision(worst.surface, worst.normal, Math.max(0, worst.speed), inside, left));
  }

  private record Hit(Surface surface, Vec3 normal, double speed) {}

  private static Hit[] hits(Vec3 push, Vec3 velocity) {
    return Stream.of(
            hit(push.x(), new Vec3(1, 0, 0), velocity, Surface.BACK_WALL, Surface.FRONT_WALL),
            hit(push.y(), new Vec3(0, 1, 0), velocity, Surface.RIGHT_WALL, Surface.LEFT_WALL),
            hit(push.z(), new Vec3(0, 0, 1), velocity, Surface.FLOOR, Surface.CEILING))
        .flatMap(Optional::stream)
        .toArray(Hit[]::new);
  }

  private static Optional<Hit> hit(
      double push, Vec3 axis, Vec3 velocity, Surface low, Surface high) {
    if (push == 0) {
      return Optional.empty();
    }
    Vec3 normal = axis.times(Math.signum(push));
    return Optional.of(new Hit(push > 0 ? low : high, normal, -velocity.dot(normal)));
  }

  private static double clamp(double value, double least, double most) {
    return Math.max(least, Math.min(most, value));
  }

  private static void check(String name, double value) {
    if (!(value >= SHORTEST && value <= LONGEST)) {
      throw new IllegalArgumentException(
          "room " + name + " is " + value + " m, but must be from " + SHORTEST + " to " + LONGEST);
    }
  }
}
