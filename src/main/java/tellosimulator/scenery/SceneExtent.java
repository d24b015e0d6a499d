package tellosimulator.scenery;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.world.Arena;
import tellosimulator.world.Footprint;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Room;

/**
 * The places that a view of the whole scene must show: the corners of the floor, and things: the
 * corners of obstacles, mission pads, starts and goals. All in the room frame [m].
 */
public final class SceneExtent {

  /** Height over a start that is seen too [m]. Decided: a drone takes off to less. */
  private static final double TAKEOFF = 1;

  /** What is seen around a start [m]. Decided: the ring of a drone, seen from some metres away. */
  private static final double RING = 0.2;

  /**
   * Height over a gate or a ball that is seen too, and half of that over a pad [m]. Decided: a tag,
   * seen from some metres away; over a pad it is raised.
   */
  private static final double TAG = 0.3;

  private SceneExtent() {}

  /** The corners of the floor. */
  public static List<Vec3> floor(Room room) {
    List<Vec3> places = new ArrayList<>();
    Vec3 size = new Vec3(room.depth(), room.width(), 0);
    addCorners(places, new Pose(Vec3.ZERO, Attitude.LEVEL), size);
    return places;
  }

  /** All that is in a room. */
  public static List<Vec3> things(Arena arena, List<Pose> starts, List<Goal> goals) {
    List<Vec3> places = new ArrayList<>();
    Room room = arena.room();
    for (Obstacle obstacle : arena.obstacles()) {
      Vec3 size = Footprint.size(obstacle.shape());
      boolean tagged =
          goals.stream()
              .anyMatch(goal -> goal instanceof Goal.Pass to && to.gate().equals(obstacle.name()));
      addCorners(places, obstacle.pose(), tagged ? size.plusScaled(Vec3.UP, TAG) : size);
    }
    for (MissionPad pad : arena.pads()) {
      boolean tagged =
          goals.stream().anyMatch(goal -> goal instanceof Goal.LandOn on && on.pad() == pad.id());
      Vec3 size = new Vec3(MissionPad.EDGE, MissionPad.EDGE, 0);
      addCorners(places, pad.pose(room), tagged ? size.plusScaled(Vec3.UP, 2 * TAG) : size);
    }
    Vec3 ring = new Vec3(2 * RING, 2 * RING, 0);
    for (Pose start : starts) {
      double height = start.position().z();
      double air = Math.max(0, Math.min(room.height(), height + TAKEOFF) - height);
      addCorners(places, new Pose(start.position(), Attitude.LEVEL), ring.withZ(air));
    }
    for (Goal goal : goals) {
      if (goal instanceof Goal.InRegion at) { // gates and mission pads are there already
        addBall(places, at.region());
      }
    }
    return places;
  }

  private static void addBall(List<Vec3> places, GoalRegion region) {
    Vec3 middle = region.place();
    for (double side : new double[] {-region.radius(), region.radius()}) {
      places.add(middle.plus(new Vec3(side, 0, 0)));
      places.add(middle.plus(new Vec3(0, side, 0)));
    }
    places.add(middle.withZ(Math.max(0, middle.z() - region.radius())));
    places.add(middle.plusScaled(Vec3.UP, region.radius() + TAG));
  }

  /**
   * The corners of a box.
   *
   * @param foot middle of its base
   * @param size depth, width and height
   */
  private static void addCorners(List<Vec3> places, Pose foot, Vec3 size) {
    for (double x : new double[] {-size.x() / 2, size.x() / 2}) {
      for (double y : new double[] {-size.y() / 2, size.y() / 2}) {
        for (double z : new double[] {0, size.z()}) {
          places.add(foot.position().plus(foot.attitude().toRoom(new Vec3(x, y, z))));
        }
      }
    }
  }
}
