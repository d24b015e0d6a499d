package tellosimulator.goal;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Function;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.words.Phrase;
import tellosimulator.world.Arena;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Poster;
import tellosimulator.world.Shape;

/**
 * The place of a goal in the room and the goal's state, for display. Immutable.
 *
 * @param number the number of the goal, from 1
 * @param drone the number of the drone that must reach the goal; empty if any drone may
 */
public record PlacedGoal(int number, OptionalInt drone, GoalState state, Place place) {

  /** Radius of the circle through the corners of a mission pad [m]. */
  private static final double AROUND_CARD = MissionPad.EDGE * Math.sqrt(0.5);

  /** The place of a goal. Coordinates are in the room frame [m]. */
  public sealed interface Place {

    /** Returns the middle of the place, at which a drone should aim. */
    Vec3 middle();

    /** Applies the function for this kind of place to this place, and returns the result. */
    <T> T match(PlaceCases<T> cases);
  }

  /** A function for each kind of place. */
  public record PlaceCases<T>(
      Function<Ball, T> ball,
      Function<Circle, T> circle,
      Function<Opening, T> opening,
      Function<Square, T> square) {}

  /** A ball that the drone's feet must enter. */
  public record Ball(Vec3 middle, double radius) implements Place {

    @Override
    public <T> T match(PlaceCases<T> cases) {
      return cases.ball().apply(this);
    }
  }

  /** A circle in which a drone must land, on the floor or on an obstacle. */
  public record Circle(Vec3 middle, double radius) implements Place {

    @Override
    public <T> T match(PlaceCases<T> cases) {
      return cases.circle().apply(this);
    }
  }

  /**
   * The opening of a gate.
   *
   * @param name the name of the gate
   * @param pose the pose of the gate's foot
   */
  public record Opening(String name, Shape.Gate gate, Pose pose, Goal.Direction direction)
      implements Place {

    @Override
    public Vec3 middle() {
      return pose.position().plusScaled(Vec3.UP, gate.middle());
    }

    @Override
    public <T> T match(PlaceCases<T> cases) {
      return cases.opening().apply(this);
    }

    /** Returns the point at the top of the gate, straight above the middle of the opening. */
    public Vec3 top() {
      return pose.position().plusScaled(Vec3.UP, gate.height());
    }

    /**
     * Returns the required direction as a unit vector in the room frame; empty if both directions
     * count.
     */
    public Optional<Vec3> way() {
      Vec3 along = pose.attitude().toRoom(new Vec3(1, 0, 0));
      return switch (direction) {
        case EITHER -> Optional.empty();
        case ALONG -> Optional.of(along);
        case AGAINST -> Optional.of(along.times(-1));
      };
    }
  }

  /**
   * A square that a drone must see: a mission pad, or a poster. The height of a poster is that of
   * its picture, which is not part of a simulation. Decided: a poster counts as a square of its
   * width.
   *
   * @param pose the pose of its middle; its z axis points out of the square, to the viewer
   * @param edge the length of an edge [m]
   */
  public record Square(Pose pose, double edge) implements Place {

    @Override
    public Vec3 middle() {
      return pose.position();
    }

    @Override
    public <T> T match(PlaceCases<T> cases) {
      return cases.square().apply(this);
    }

    /** Returns the corners, counter-clockwise as seen by a viewer. */
    public List<Vec3> corners() {
      Vec3 up = pose.attitude().toRoom(new Vec3(edge / 2, 0, 0));
      Vec3 left = pose.attitude().toRoom(new Vec3(0, edge / 2, 0));
      return List.of(
          middle().plus(up).plus(left),
          middle().minus(up).plus(left),
          middle().minus(up).minus(left),
          middle().plus(up).minus(left));
    }

    /** Returns the direction from the square to a viewer in front of it, a unit vector. */
    public Vec3 out() {
      return pose.attitude().up();
    }
  }

  /** Returns everything in a room that a goal can ask to see, and where it is. */
  public static Map<Goal.Target, Square> targets(Arena arena) {
    Map<Goal.Target, Square> targets = new LinkedHashMap<>();
    for (Poster poster : arena.decor().posters()) {
      targets.putIfAbsent(
          new Goal.NamedPoster(poster.name()),
          new Square(poster.pose(arena.room()), poster.width()));
    }
    for (MissionPad pad : arena.pads()) {
      targets.put(
          new Goal.NumberedPad(pad.id()), new Square(pad.pose(arena.room()), MissionPad.EDGE));
    }
    return targets;
  }

  /** Returns the placed goals for all goals that have a place, in the order of their numbers. */
  public static List<PlacedGoal> of(Progress progress, Arena arena) {
    List<Goal> goals = progress.challenge().goals();
    if (goals.isEmpty()) {
      return List.of();
    }
    Course course = new Course(arena);
    List<PlacedGoal> marks = new ArrayList<>();
    for (int i = 0; i < goals.size(); i++) {
      int index = i;
      Goal goal = goals.get(i);
      place(goal, course)
          .map(place -> new PlacedGoal(index + 1, goal.drone(), progress.state(index), place))
          .ifPresent(marks::add);
    }
    return List.copyOf(marks);
  }

  /**
   * Describes a goal's task and place. Unlike {@link Goal#task}, the description contains the
   * coordinates of a gate or a mission pad, the height of a landing place above the floor, and the
   * direction in which to fly through a gate. The place of what must be seen is not described,
   * since it is to be found.
   */
  public static Phrase task(Goal goal, Arena arena) {
    PlaceCases<Phrase> tasks =
        new PlaceCases<>(
            ball -> goal.task(),
            circle -> landing(goal, circle.middle().times(100)),
            opening -> passage(opening, opening.middle().times(100)),
            square -> goal.task());
    return place(goal, new Course(arena)).map(place -> place.match(tasks)).orElseGet(goal::task);
  }

  private static Phrase landing(Goal goal, Vec3 cm) {
    if (goal instanceof Goal.LandOn on) {
      return Phrase.of("land on mission pad %d at x %.0f, y %.0f cm", on.pad(), cm.x(), cm.y());
    }
    return cm.z() < 1
        ? goal.task()
        : Phrase.of("land at x %.0f, y %.0f, z %.0f cm", cm.x(), cm.y(), cm.z());
  }

  private static Phrase passage(Opening opening, Vec3 cm) {
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

  /**
   * Returns the name of a horizontal direction: an axis such as {@code -y}, or the angle from the x
   * axis for directions that are not along an axis.
   */
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

  /** Returns the places of those goals that have a place. */
  public static List<Place> places(List<Goal> goals, Arena arena) {
    Course course = new Course(arena);
    return goals.stream().flatMap(goal -> place(goal, course).stream()).toList();
  }

  /** Returns the first goal that a drone can reach now. */
  public static Optional<PlacedGoal> next(List<PlacedGoal> marks, int drone) {
    return marks.stream()
        .filter(mark -> mark.state == GoalState.ACTIVE && mark.drone.orElse(drone) == drone)
        .findFirst();
  }

  /** Returns the place of a goal; empty if the object that it names does not exist. */
  private static Optional<Place> place(Goal goal, Course course) {
    return goal.match(
        new Goal.Cases<>(
            reach -> Optional.of(ball(reach.region())),
            hover -> Optional.of(ball(hover.region())),
            pass ->
                course
                    .gate(pass.gate())
                    .map(g -> new Opening(pass.gate(), g.opening(), g.pose(), pass.direction())),
            land ->
                Optional.of(
                    new Circle(course.onTop(land.region().place()), land.region().radius())),
            landOn ->
                course.card(landOn.pad()).map(card -> new Circle(card.position(), AROUND_CARD)),
            see -> course.square(see.target()).map(Place.class::cast)));
  }

  private static Ball ball(GoalRegion region) {
    return new Ball(region.place(), region.radius());
  }
}
