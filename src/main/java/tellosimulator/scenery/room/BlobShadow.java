package tellosimulator.scenery.room;

import java.util.Arrays;
import java.util.List;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.Quad;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.world.Arena;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Obstacles;

/**
 * The blob shadows of drones: soft round decals straight below them, on the floor or on an
 * obstacle. They shrink and fade as a drone rises, but never vanish. The spatial index of the most
 * recent obstacles is cached. Thread-safe.
 */
public final class BlobShadow {

  /**
   * Radius of the shadow of a drone that stands on the floor [m]: a little larger than the drone.
   * Decided: by eye.
   */
  private static final double LARGEST = 0.15;

  private static final double SMALLEST = 0.08;

  private static final double DARKEST = 0.6;

  private static final double LIGHTEST = 0.22;

  /**
   * Height at which size and opacity of the shadow are halfway between their extremes [m]. Decided:
   * by eye.
   */
  private static final double HALF_HEIGHT = 1.2;

  private static final Vec3 DOWN = Vec3.UP.times(-1);

  /**
   * Height above the drone's feet at which the downward ray starts [m]. The ray must start above
   * the feet in case the drone stands on something. Decided.
   */
  private static final double ABOVE = 0.01;

  /**
   * Heights that differ by less than this are considered equal [m]. Decided: far more than rounding
   * errors.
   */
  private static final double LEVEL = 0.002;

  /**
   * Factor by which the radius shrinks with each attempt to fit the shadow on an obstacle. Decided:
   * by eye.
   */
  private static final double NARROWER = 0.7;

  /** Radius below which a shadow does not become narrower [m]. Decided: by eye. */
  private static final double NARROWEST = 0.02;

  private static final int DIRECTIONS = 8;

  /** The part that all shadows share; it is created together with the first shadow. */
  private static final class Shared {
    static final Part PART = new Part(MeshBuilder.of(Quad.onFloor(2)), texture(), Shading.DECAL);
  }

  private record Index(List<Obstacle> list, Obstacles obstacles) {}

  private volatile Index index = new Index(List.of(), Obstacles.of(Arena.DEFAULT));

  /**
   * The place and appearance of a shadow.
   *
   * @param height height above the floor of the surface on which the shadow falls [m]
   * @param radius radius in metres
   * @param opacity 0 to 1
   */
  record Shadow(double height, double radius, double opacity) {

    /**
     * Creates the shadow of a drone on a surface below it.
     *
     * @param height height of the surface above the floor [m]
     * @param above height of the drone above the surface [m]
     */
    static Shadow on(double height, double above) {
      double near = HALF_HEIGHT / (HALF_HEIGHT + Math.max(0, above));
      return new Shadow(
          height, SMALLEST + (LARGEST - SMALLEST) * near, LIGHTEST + (DARKEST - LIGHTEST) * near);
    }

    Shadow narrower() {
      return new Shadow(height, NARROWER * radius, opacity);
    }
  }

  /**
   * Returns the shadow of a drone as a decal.
   *
   * @param position position of the drone, in the room frame [m]
   */
  public Instance of(Arena arena, Vec3 position) {
    Shadow shadow = cast(arena, position);
    Pose below = new Pose(position.withZ(shadow.height), Attitude.LEVEL);
    return new Instance(Shared.PART, below, shadow.radius, shadow.opacity);
  }

  /**
   * Casts a shadow. On an obstacle, the shadow is made narrower until it does not extend beyond the
   * edge of the obstacle.
   */
  Shadow cast(Arena arena, Vec3 position) {
    Obstacles obstacles = obstacles(arena);
    double height = height(obstacles, position);
    Shadow shadow = Shadow.on(height, position.z() - height);
    while (height > 0 && shadow.radius > NARROWEST && !level(obstacles, position, shadow.radius)) {
      shadow = shadow.narrower();
    }
    return shadow;
  }

  private Obstacles obstacles(Arena arena) {
    Index latest = index;
    List<Obstacle> list = arena.obstacles();
    if (latest.list != list) { // by identity: the first call of equals takes 20 ms
      latest = new Index(list, Obstacles.of(arena));
      index = latest;
    }
    return latest.obstacles;
  }

  /**
   * Returns whether none of the points sampled on a circle around the position is lower than the
   * surface below the position.
   *
   * @param radius radius of the circle [m]
   */
  private static boolean level(Obstacles obstacles, Vec3 position, double radius) {
    double middle = height(obstacles, position);
    for (int i = 0; i < DIRECTIONS; i++) {
      Vec3 out = new Vec3(radius, 0, 0).turned(2 * Math.PI * i / DIRECTIONS);
      if (height(obstacles, position.plus(out)) < middle - LEVEL) {
        return false;
      }
    }
    return true;
  }

  private static double height(Obstacles obstacles, Vec3 position) {
    double from = Math.max(0, position.z()) + ABOVE;
    double down = obstacles.distance(position.withZ(from), DOWN, from);
    return down < from ? from - down : 0;
  }

  /** Creates a black texture whose alpha falls off towards the rim. */
  private static Texture texture() {
    int size = 64;
    int[] argb = new int[size * size];
    Arrays.setAll(
        argb,
        i -> {
          int row = i / size;
          double x = (i - row * size + 0.5) / (size / 2.0) - 1;
          double y = (row + 0.5) / (size / 2.0) - 1;
          double part = Math.max(0, 1 - x * x - y * y);
          return Rgb.BLACK.argb(part * part);
        });
    return new Texture(size, size, argb);
  }
}
