package tellosimulator.goal;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.words.Phrase;
import tellosimulator.world.Arena;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Obstacles;
import tellosimulator.world.Shape;
import tellosimulator.world.Surface;

/**
 * Where a goal is in the room, and how one stands with it, for whoever draws it. Immutable.
 *
 * @param number of the goal, from 1
 * @param drone the number of the drone that shall do it; empty if any may
 */
public record GoalMark(int number, OptionalInt drone, GoalState state, Place place) {

  private static final Vec3 DOWN = Vec3.UP.times(-1);

  /** What is to be reached. Room frame [m]. */
  public sealed interface Place {

    /** Its middle, to which one flies. */
    Vec3 middle();
  }

  /** A ball in which the drone's feet shall be. */
  public record Ball(Vec3 middle, double radius) implements Place {}

  /** A circle to land on, on the floor or on an obstacle. */
  public record Circle(Vec3 middle, double radius) implements Place {}

  /**
   * The opening of a gate.
   *
   * @param name of the gate
   * @param pose of the gate's foot
   */
  public record Opening(String name, Shape.Gate gate, Pose pose, Goal.Direction direction)
      implements Place {

    @Override
    public Vec3 middle() {
      return pose.position().plusScaled(Vec3.UP, gate.middle());
    }

    /** The highest place of the gate, over its middle. */
    public Vec3 top() {
      return pose.position().plusScaled(Vec3.UP, gate.height());
    }

    /** Where one shall fly, a unit vector; empty if either way counts. */
    public Optional<Vec3> way() {
      Vec3 along = pose.attitude().toRoom(new Vec3(1, 0, 0));
      return switch (direction) {
        case EITHER -> Optional.empty();
        case ALONG -> Optional.of(along);
        case AGAINST -> Optional.of(along.times(-1));
      };
    }
  }

  /** The marks of all goals that are somewhere in a room, in the order of their numbers. */
  public static List<GoalMark> of(Progress progress, Arena arena) {
    List<Goal> goals = progress.challenge().goals();
    if (goals.isEmpty()) {
      return List.of();
    }
    Obstacles obstacles = Obstacles.of(arena);
    List<GoalMark> marks = new ArrayList<>();
    for (int i = 0; i < goals.size(); i++) {
      int index = i;
      Goal goal = goals.get(i);
      place(goal, arena, obstacles)
          .map(place -> new GoalMark(index + 1, goal.drone(), progress.state(index), place))
          .ifPresent(marks::add);
    }
    return List.copyOf(marks);
  }

  /**
   * What to do and where: that of a {@link Goal#task}, with place, height and direction of what a
   * goal only names.
   */
  public static Phrase task(Goal goal, Arena arena) {
    Optional<Place> place = place(goal, arena, Obstacles.of(arena));
    if (place.isEmpty() || goal instanceof Goal.Reach || goal instanceof Goal.Hover) {
      return goal.task();
    }
    Vec3 cm = place.get().middle().times(100);
    if (place.get() instanceof Opening opening) {
      return opening
          .way()
          .map(
              way ->
                  Phrase.of(
                      "fly through gate %s at x %.0f, y %.0f, z %.0f cm, in the direction of %s",
                      opening.name(), cm.x(), cm.y(), cm.z(), axis(way)))
          .orElse(
              Phrase.of(
                  "fly through gate %s at x %.0f, y %.0f, z %.0f cm",
                  opening.name(), cm.x(), cm.y(), cm.z()));
    }
    if (goal instanceof Goal.LandOn on) {
      return Phrase.of("land on mission pad %d at x %.0f, y %.0f cm", on.pad(), cm.x(), cm.y());
    }
    return cm.z() < 1
        ? goal.task()
        : Phrase.of("land at x %.0f, y %.0f, z %.0f cm", cm.x(), cm.y(), cm.z());
  }

  /** The axis along which a level way leads, {@code x} or {@code -y}, or else its heading. */
  private static String axis(Vec3 way) {
    long degrees = Math.round(StrictMath.toDegrees(StrictMath.atan2(way.y(), way.x())));
    return switch ((int) degrees) {
      case 0 -> "x";
      case 90 -> "y";
      case 180, -180 -> "-x";
      case -90 -> "-y";
      default -> degrees + "°";
    };
  }

  /** Where goals are, of those that are somewhere in a room. */
  public static List<Place> places(List<Goal> goals, Arena arena) {
    Obstacles obstacles = Obstacles.of(arena);
    return goals.stream().flatMap(goal -> place(goal, arena, obstacles).stream()).toList();
  }

  /** The first mark that can be reached now by a drone. */
  public static Optional<GoalMark> next(List<GoalMark> marks, int drone) {
    return marks.stream()
        .filter(mark -> mark.state == GoalState.ACTIVE && mark.drone.orElse(drone) == drone)
        .findFirst();
  }

  /** Empty if what the goal names is not there. */
  private static Optional<Place> place(Goal goal, Arena arena, Obstacles obstacles) {
    if (goal instanceof Goal.Reach reach) {
      return Optional.of(new Ball(reach.region().place(), reach.region().radius()));
    }
    if (goal instanceof Goal.Hover hover) {
      return Optional.of(new Ball(hover.region().place(), hover.region().radius()));
    }
    if (goal instanceof Goal.Pass pass) {
      return arena.obstacles().stream()
          .filter(obstacle -> obstacle.name().equals(pass.gate()))
          .flatMap(obstacle -> opening(obstacle, pass.direction()).stream())
          .findFirst();
    }
    if (goal instanceof Goal.Land land) {
      Vec3 on = onTop(land.region().place(), arena, obstacles);
      return Optional.of(new Circle(on, land.region().radius()));
    }
    int id = ((Goal.LandOn) goal).pad();
    return arena.pads().stream()
        .filter(pad -> pad.id() == id && pad.surface() == Surface.FLOOR)
        .map(pad -> (Place) around(pad, arena))
        .findFirst();
  }

  private static Optional<Place> opening(Obstacle obstacle, Goal.Direction direction) {
    return obstacle.shape() instanceof Shape.Gate gate
        ? Optional.of(new Opening(obstacle.name(), gate, obstacle.pose(), direction))
        : Optional.empty();
  }

  /** The circle through the corners of a card. */
  private static Circle around(MissionPad pad, Arena arena) {
    return new Circle(pad.pose(arena.room()).position(), MissionPad.EDGE * Math.sqrt(0.5));
  }

  /** On the highest thing that is at a place of the floor. */
  private static Vec3 onTop(Vec3 place, Arena arena, Obstacles obstacles) {
    double ceiling = arena.room().height();
    double down = obstacles.distance(place.withZ(ceiling), DOWN, ceiling);
    return place.withZ(down < ceiling ? ceiling - down : 0);
  }
}
