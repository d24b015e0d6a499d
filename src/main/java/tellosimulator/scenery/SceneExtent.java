package tellosimulator.scenery;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.goal.Goal;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.goal.PlacedGoal.PlaceCases;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.world.Arena;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Room;

/**
 * The points that a view of the whole scene must include: the corners of the floor, and points
 * around the obstacles, mission pads, start positions and goals. All points are in the room frame
 * [m].
 */
public final class SceneExtent {

  /** Height above a start to keep in view [m]. Decided: higher than a drone climbs on take-off. */
  private static final double TAKEOFF = 1;

  /**
   * Radius around a start to keep in view [m]. Decided: the size of a drone's ring seen from a few
   * metres away.
   */
  private static final double RING = 0.2;

  /**
   * Height above a gate or a ball to keep in view [m]; above a circle it is doubled, because the
   * tag there is raised. Decided: the size of a tag seen from a few metres away.
   */
  private static final double TAG = 0.3;

  private SceneExtent() {}

  /** Returns the corners of the floor. */
  public static List<Vec3> floor(Room room) {
    List<Vec3> places = new ArrayList<>();
    Vec3 size = new Vec3(room.depth(), room.width(), 0);
    addCorners(places, new Pose(Vec3.ZERO, Attitude.LEVEL), size);
    return places;
  }

  /** Returns the centre of the bounding box of some points. */
  public static Vec3 middle(List<Vec3> points) {
    Vec3 least = points.get(0);
    Vec3 most = points.get(0);
    for (Vec3 each : points) {
      least =
          new Vec3(
              Math.min(least.x(), each.x()),
              Math.min(least.y(), each.y()),
              Math.min(least.z(), each.z()));
      most =
          new Vec3(
              Math.max(most.x(), each.x()),
              Math.max(most.y(), each.y()),
              Math.max(most.z(), each.z()));
    }
    return least.plus(most).times(0.5);
  }

  /** Returns the points around the obstacles, mission pads, starts and goals in a room. */
  public static List<Vec3> things(Arena arena, List<Pose> starts, List<Goal> goals) {
    List<Vec3> places = new ArrayList<>();
    Room room = arena.room();
    for (Obstacle obstacle : arena.obstacles()) {
      addCorners(places, obstacle.pose(), obstacle.shape().size());
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
    PlacedGoal.places(goals, arena).forEach(place -> places.addAll(around(place)));
    return places;
  }

  /**
   * Returns the points around a goal and its tag. For a gate, the only point is the top of the tag,
   * because the gate itself is one of the obstacles.
   */
  private static List<Vec3> around(PlacedGoal.Place place) {
    Vec3 middle = place.middle();
    return place.match(
        new PlaceCases<>(
            ball ->
                around(
                    middle,
                    ball.radius(),
                    middle.withZ(Math.max(0, middle.z() - ball.radius())),
                    middle.plusScaled(Vec3.UP, ball.radius() + TAG)),
            circle -> around(middle, circle.radius(), middle.plusScaled(Vec3.UP, 2 * TAG)),
            gate -> List.of(gate.top().plusScaled(Vec3.UP, TAG)),
            square -> around(middle, square.edge() / 2, middle.plusScaled(Vec3.UP, 2 * TAG))));
  }

  private static List<Vec3> around(Vec3 middle, double radius, Vec3... others) {
    List<Vec3> places = new ArrayList<>(List.of(others));
    for (double side : new double[] {-radius, radius}) {
      places.add(middle.plus(new Vec3(side, 0, 0)));
      places.add(middle.plus(new Vec3(0, side, 0)));
    }
    return places;
  }

  /**
   * Adds the corners of a box.
   *
   * @param foot pose of the middle of the box's base
   * @param size depth, width and height of the box [m]
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
