package tellosimulator.scenery;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalMark;
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
   * Height over a gate or a ball that is seen too, and twice that over a circle [m]. Decided: a
   * tag, seen from some metres away; over a circle it is raised.
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
      addCorners(places, obstacle.pose(), Footprint.size(obstacle.shape()));
    }
    for (MissionPad pad : arena.pads()) {
      addCorners(places, pad.pose(room), new Vec3(MissionPad.EDGE, MissionPad.EDGE, 0));
    }
    Vec3 ring = new Vec3(2 * RING, 2 * RING, 0);
    for (Pose start : starts) {
      double height = start.position().z();
      double air = Math.max(0, Math.min(room.height(), height + TAKEOFF) - height);
      addCorners(places, new Pose(start.position(), Attitude.LEVEL), ring.withZ(air));
    }
    for (GoalMark.Place place : GoalMark.places(goals, arena)) {
      addGoal(places, place);
    }
    return places;
  }

  /** What shows a goal, with its tag. */
  private static void addGoal(List<Vec3> places, GoalMark.Place place) {
    Vec3 middle = place.middle();
    if (place instanceof GoalMark.Ball ball) {
      addAround(places, middle, ball.radius());
      places.add(middle.withZ(Math.max(0, middle.z() - ball.radius())));
      places.add(middle.plusScaled(Vec3.UP, ball.radius() + TAG));
    } else if (place instanceof GoalMark.Circle circle) {
      addAround(places, middle, circle.radius());
      places.add(middle.plusScaled(Vec3.UP, 2 * TAG));
    } else if (place instanceof GoalMark.Opening gate) { // which is among the obstacles
      places.add(gate.top().plusScaled(Vec3.UP, TAG));
    }
  }

  private static void addAround(List<Vec3> places, Vec3 middle, double radius) {
    for (double side : new double[] {-radius, radius}) {
      places.add(middle.plus(new Vec3(side, 0, 0)));
      places.add(middle.plus(new Vec3(0, side, 0)));
    }
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
