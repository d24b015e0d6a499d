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
 * obstacle. They shrink and fade as a drone rises, but never vanish. Keeps the spatial index of the
 * latest obstacles. For any thread.
 */
public final class BlobShadow {

  /** Radius on the floor [m]: a little more than the drone. Decided: by eye. */
  private static final double LARGEST = 0.15;

  private static final double SMALLEST = 0.08;

  private static final double DARKEST = 0.6;

  private static final double LIGHTEST = 0.22;

  /** Height at which half of the change has happened [m]. Decided: by eye. */
  private static final double HALF_HEIGHT = 1.2;

  private static final Vec3 DOWN = Vec3.UP.times(-1);

  /** From here above its feet a ray goes down, so that it may stand on something [m]. Decided. */
  private static final double ABOVE = 0.01;

  /** What differs by less is the same height [m]. Decided: far more than rounding does. */
  private static final double LEVEL = 0.002;

  /** How much narrower each next try is. Decided: by eye. */
  private static final double NARROWER = 0.7;

  /** Narrowest shadow [m]. Decided: by eye. */
  private static final double NARROWEST = 0.02;

  private static final int DIRECTIONS = 8;

  /** Made for the first drone. */
  private static final class Shared {
    static final Part PART = new Part(MeshBuilder.of(Quad.onFloor(2)), texture(), Shading.DECAL);
  }

  private record Index(List<Obstacle> list, Obstacles obstacles) {}

  private volatile Index index = new Index(List.of(), Obstacles.of(Arena.DEFAULT));

  /**
   * Where a shadow falls, and how.
   *
   * @param height of what it falls on, above the floor [m]
   * @param radius metres
   * @param opacity 0 to 1
   */
  record Shadow(double height, double radius, double opacity) {

    /** A shadow that falls on something high [m] from a drone so far above it [m]. */
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
   * The shadow of a drone as a decal.
   *
   * @param position of the drone, room frame [m]
   */
  public Instance of(Arena arena, Vec3 position) {
    Shadow shadow = cast(arena, position);
    Pose below = new Pose(position.withZ(shadow.height), Attitude.LEVEL);
    return new Instance(Shared.PART, below, shadow.radius, shadow.opacity);
  }

  /** On an obstacle it is so narrow that it does not stand out over the edge. */
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
    if (latest.list != list) { // not equals, which takes 20 ms when it is first called
      latest = new Index(list, Obstacles.of(arena));
      index = latest;
    }
    return latest.obstacles;
  }

  /** Whether all around is as high as the middle, or higher. */
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

  /** Black, with an alpha that falls off towards the rim. */
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
