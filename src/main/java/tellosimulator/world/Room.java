package tellosimulator.world;

import java.util.Optional;
import java.util.stream.Stream;
import tellosimulator.math.Vec3;

/**
 * A box with its floor's centre at the origin of the room frame. Immutable.
 *
 * @param width along y [m]
 * @param depth along x [m]
 * @param height along z [m]
 */
public record Room(double width, double depth, double height) {

  /** Decided: 5 by 5 by 3 m, as the predecessor's room. */
  public static final Room DEFAULT = new Room(5, 5, 3);

  /** Shortest edge [m]. Assumed: a drone, its start and some air. */
  public static final double SHORTEST = 1;

  /** Longest edge [m]. Assumed: the drone's Wi-Fi reaches 100 m. */
  public static final double LONGEST = 200;

  public Room {
    check("width", width);
    check("depth", depth);
    check("height", height);
  }

  /** Whether the collider fits at {@code position} without touching a wall or the ceiling. */
  public boolean contains(Vec3 position, Collider collider) {
    return Math.abs(position.x()) <= depth / 2 - collider.radius()
        && Math.abs(position.y()) <= width / 2 - collider.radius()
        && position.z() >= 0
        && position.z() <= height - collider.height();
  }

  /** How far it is from the room's middle to a wall [m]. */
  public double distanceTo(Surface wall) {
    return (alongDepth(wall) ? width : depth) / 2;
  }

  /** How long a wall is [m]; how wide floor and ceiling are. */
  public double lengthOf(Surface surface) {
    return alongDepth(surface) ? depth : width;
  }

  private static boolean alongDepth(Surface surface) {
    return surface == Surface.LEFT_WALL || surface == Surface.RIGHT_WALL;
  }

  /**
   * How far it is from a place inside to the side that a ray leaves through [m].
   *
   * @param direction unit vector
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

  /** The position nearest to {@code position} at which the collider fits. */
  public Vec3 nearestInside(Vec3 position, Collider collider) {
    return new Vec3(
        clamp(position.x(), -(depth / 2 - collider.radius()), depth / 2 - collider.radius()),
        clamp(position.y(), -(width / 2 - collider.radius()), width / 2 - collider.radius()),
        clamp(position.z(), 0, height - collider.height()));
  }

  /**
   * What stops a body; it slides along the surface.
   *
   * @param position where it would be [m]
   * @param velocity how it moves [m/s]
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
