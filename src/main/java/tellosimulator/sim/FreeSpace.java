package tellosimulator.sim;

import java.util.List;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.world.Collider;
import tellosimulator.world.Obstacles;
import tellosimulator.world.Room;

/**
 * The space in which a drone can fly without touching a wall, an obstacle or another drone, as of
 * one snapshot. Immutable.
 */
public final class FreeSpace {

  /**
   * Clearance from obstacles and drones [m]. It allows for the accumulated error of several moves.
   * Measured: a move ends about 2.5 cm off its goal.
   */
  private static final double AIR = 0.1;

  /** Distance between two successive points at which a path is tested [m]. */
  private static final double STRIDE = 0.04;

  private static final Collider WITH_AIR =
      new Collider(DroneSpec.COLLIDER.radius() + AIR, DroneSpec.COLLIDER.height() + 2 * AIR);

  private final Room room;
  private final Obstacles obstacles;
  private final List<Vec3> others;

  /**
   * Creates the free space of a drone.
   *
   * @param drone the number of the drone that will fly, from 1
   */
  public FreeSpace(SimSnapshot snapshot, int drone) {
    room = snapshot.room();
    obstacles = Obstacles.of(snapshot.arena());
    others =
        snapshot.drones().stream()
            .filter(other -> other.state().drone() != drone)
            .map(other -> other.state().motion().position())
            .toList();
  }

  /** Returns whether a path is free for the drone. The points are in the room frame [m]. */
  public boolean holds(List<Vec3> path) {
    for (int i = 1; i < path.size(); i++) {
      Vec3 way = path.get(i).minus(path.get(i - 1));
      int strides = Math.max(1, (int) Math.ceil(way.norm() / STRIDE));
      for (int stride = 1; stride <= strides; stride++) {
        if (!holds(path.get(i - 1).plusScaled(way, (double) stride / strides))) {
          return false;
        }
      }
    }
    return true;
  }

  private boolean holds(Vec3 feet) {
    return room.contains(feet, DroneSpec.COLLIDER)
        && obstacles.around(feet.plusScaled(Vec3.UP, -AIR), WITH_AIR).isEmpty()
        && others.stream().noneMatch(other -> meet(feet, other));
  }

  private static boolean meet(Vec3 feet, Vec3 other) {
    Vec3 offset = feet.minus(other);
    return offset.horizontal().norm() < 2 * DroneSpec.COLLIDER.radius() + AIR
        && Math.abs(offset.z()) < DroneSpec.COLLIDER.height() + AIR;
  }
}
