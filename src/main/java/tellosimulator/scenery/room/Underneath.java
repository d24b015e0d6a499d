package tellosimulator.scenery.room;

import tellosimulator.math.Vec3;
import tellosimulator.world.Arena;
import tellosimulator.world.Obstacles;

/**
 * What is right under a drone, on which its shadow falls: the floor, or an obstacle. It keeps what
 * it needs for the latest arena. For any thread.
 */
public final class Underneath {

  private static final Vec3 DOWN = Vec3.UP.times(-1);

  /** From here above its feet one looks down, so that it may stand on something [m]. Decided. */
  private static final double ABOVE = 0.01;

  /** What differs by less is the same height [m]. Decided: far more than rounding does. */
  private static final double LEVEL = 0.002;

  /** How much narrower each next try is. Decided: by eye. */
  private static final double NARROWER = 0.7;

  /** Narrowest shadow [m]. Decided: by eye. */
  private static final double NARROWEST = 0.02;

  private static final int DIRECTIONS = 8;

  private record Known(Arena arena, Obstacles obstacles) {}

  private volatile Known known = new Known(Arena.DEFAULT, Obstacles.of(Arena.DEFAULT));

  /**
   * Where a shadow is.
   *
   * @param height of what it falls on, above the floor [m]
   * @param radius metres
   */
  record Place(double height, double radius) {}

  /**
   * Where the shadow of a drone falls. On an obstacle it is so narrow that it does not stand out
   * over the edge.
   *
   * @param position of the drone [m]
   */
  Place of(Arena arena, Vec3 position) {
    Obstacles obstacles = obstacles(arena);
    double height = height(obstacles, position);
    double radius = Shadow.at(position.z() - height).radius();
    while (height > 0 && radius > NARROWEST && !level(obstacles, position, radius)) {
      radius *= NARROWER;
    }
    return new Place(height, radius);
  }

  private Obstacles obstacles(Arena arena) {
    Known latest = known;
    if (!latest.arena.equals(arena)) {
      latest = new Known(arena, Obstacles.of(arena));
      known = latest;
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
}
