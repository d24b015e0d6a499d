package tellosimulator.goal;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import tellosimulator.goal.PlacedGoal.Square;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.world.Arena;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Obstacles;
import tellosimulator.world.Shape;
import tellosimulator.world.Surface;

/**
 * The places in an arena to which goals refer: gates, mission pads, posters and landing surfaces.
 */
final class Course {

  private static final Vec3 DOWN = Vec3.UP.times(-1);

  /**
   * Share of a line of sight that must be free. Decided: the rest allows for rounding where an
   * obstacle adjoins the target.
   */
  private static final double FREE = 0.999;

  /** The opening of a gate, with the pose of the gate's foot. */
  record Gate(Shape.Gate opening, Pose pose) {}

  private final Arena arena;
  private final Obstacles obstacles;
  private final Map<String, Gate> gates = new HashMap<>();
  private final Map<Integer, Pose> cards = new HashMap<>();
  private final Map<Goal.Target, Square> squares;

  Course(Arena arena) {
    this.arena = arena;
    obstacles = Obstacles.of(arena);
    squares = PlacedGoal.targets(arena);
    for (Obstacle obstacle : arena.obstacles()) {
      if (obstacle.shape() instanceof Shape.Gate opening) {
        gates.putIfAbsent(obstacle.name(), new Gate(opening, obstacle.pose()));
      }
    }
    for (MissionPad pad : arena.pads()) {
      if (pad.surface() == Surface.FLOOR) {
        cards.put(pad.id(), pad.pose(arena.room()));
      }
    }
  }

  /** Returns the course in an arena: this course if the arena is the same, otherwise a new one. */
  Course in(Arena present) {
    return present.equals(arena) ? this : new Course(present);
  }

  Optional<Gate> gate(String name) {
    return Optional.ofNullable(gates.get(name));
  }

  /** Returns the pose of a mission pad that lies on the floor; empty if there is no such pad. */
  Optional<Pose> card(int pad) {
    return Optional.ofNullable(cards.get(pad));
  }

  Optional<Square> square(Goal.Target target) {
    return Optional.ofNullable(squares.get(target));
  }

  /** Whether no obstacle hides the middle or a corner of a square from an eye. */
  boolean isVisible(Square square, Vec3 eye) {
    return free(eye, square.middle())
        && square.corners().stream().allMatch(corner -> free(eye, corner));
  }

  private boolean free(Vec3 eye, Vec3 place) {
    Vec3 way = place.minus(eye);
    double limit = FREE * way.norm();
    return obstacles.distance(eye, way.normalized(), limit) >= limit;
  }

  /**
   * Returns the point at which a vertical line through a place on the floor meets the top of the
   * highest obstacle; if there is no obstacle, the point on the floor.
   */
  Vec3 onTop(Vec3 place) {
    double ceiling = arena.room().height();
    double down = obstacles.distance(place.withZ(ceiling), DOWN, ceiling);
    return place.withZ(down < ceiling ? ceiling - down : 0);
  }
}
