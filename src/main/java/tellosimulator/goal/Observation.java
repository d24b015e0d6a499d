package tellosimulator.goal;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import tellosimulator.goal.Observation.Course.Gate;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.DroneState;
import tellosimulator.model.FlightPhase;
import tellosimulator.world.Arena;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Shape;
import tellosimulator.world.Surface;

/**
 * What is seen of a drone in one step.
 *
 * @param course in which it flies
 * @param before at the end of the step before
 * @param now at the end of the step
 * @param flown whether it has flown since the challenge began
 */
record Observation(Course course, DroneState before, DroneState now, boolean flown) {

  /** From the feet to the drone's centre. */
  private static final Vec3 CENTER = Vec3.UP.times(DroneSpec.COLLIDER.height() / 2);

  /** Highest feet over a card on which a drone stands [m]. Decided: a sheet and rounding. */
  private static final double ON_CARD = 0.01;

  int drone() {
    return now.drone();
  }

  /** Whether the drone does what is asked for; that of a {@link Goal.Hover} must last. */
  boolean reaches(Goal goal) {
    if (goal.drone().isPresent() && goal.drone().getAsInt() != drone()) {
      return false;
    }
    if (goal instanceof Goal.Reach reach) {
      return flies() && reach.region().holds(feet());
    }
    if (goal instanceof Goal.Hover hover) {
      return flies() && hover.region().holds(feet());
    }
    if (goal instanceof Goal.Pass pass) {
      return course.gate(pass.gate()).filter(gate -> passes(gate, pass.direction())).isPresent();
    }
    if (goal instanceof Goal.Land land) {
      return landed() && land.region().holdsLevel(feet());
    }
    return landed() && course.card(((Goal.LandOn) goal).pad()).filter(this::standsOn).isPresent();
  }

  private Vec3 feet() {
    return now.motion().position();
  }

  private boolean flies() {
    return now.phase().flying();
  }

  private boolean landed() {
    return flown && now.phase() == FlightPhase.GROUNDED;
  }

  /** Whether it came down in this step, after a flight. */
  boolean justLanded() {
    return landed() && before.phase() != FlightPhase.GROUNDED;
  }

  /** Whether it was switched off in the air. */
  boolean lostPower() {
    return before.phase().flying() && now.phase() == FlightPhase.OFF;
  }

  private boolean passes(Gate gate, Goal.Direction direction) {
    return crossing(gate)
        .filter(crossing -> crossing.through() && crossing.goes(direction))
        .isPresent();
  }

  /** How its centre crossed the plane of a gate's opening in this step. */
  Optional<Crossing> crossing(Gate gate) {
    Vec3 from = inFrame(gate, before);
    Vec3 to = inFrame(gate, now);
    boolean along = from.x() < 0 && to.x() >= 0;
    boolean against = from.x() > 0 && to.x() <= 0;
    if (!flies() || !(along || against)) {
      return Optional.empty();
    }
    Vec3 place = from.plusScaled(to.minus(from), from.x() / (from.x() - to.x()));
    double up = place.z() - gate.opening().middle();
    return Optional.of(new Crossing(along, place.y(), up, gate.opening().opens(place.y(), up)));
  }

  /**
   * A way across the plane of a gate's opening.
   *
   * @param along whether along the gate's x axis, not against it
   * @param across from the middle of the opening, along the gate's y axis [m]
   * @param up from the middle of the opening [m]
   * @param through whether through the opening, not past it
   */
  record Crossing(boolean along, double across, double up, boolean through) {

    boolean goes(Goal.Direction direction) {
      return switch (direction) {
        case EITHER -> true;
        case ALONG -> along;
        case AGAINST -> !along;
      };
    }
  }

  private static Vec3 inFrame(Gate gate, DroneState drone) {
    Vec3 center = drone.motion().position().plus(CENTER);
    return gate.pose().attitude().toBody(center.minus(gate.pose().position()));
  }

  private boolean standsOn(Pose card) {
    Vec3 offset = card.attitude().toBody(feet().minus(card.position()));
    return Math.abs(offset.x()) <= MissionPad.EDGE / 2
        && Math.abs(offset.y()) <= MissionPad.EDGE / 2
        && offset.z() <= ON_CARD;
  }

  /** What goals name in an arena, found quickly. Immutable. */
  static final class Course {

    /** An opening and where the foot of its gate is. */
    record Gate(Shape.Gate opening, Pose pose) {}

    private final Arena arena;
    private final Map<String, Gate> gates = new HashMap<>();
    private final Map<Integer, Pose> cards = new HashMap<>();

    Course(Arena arena) {
      this.arena = arena;
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

    /** Itself, unless the arena is another one. */
    Course in(Arena present) {
      return present.equals(arena) ? this : new Course(present);
    }

    Optional<Gate> gate(String name) {
      return Optional.ofNullable(gates.get(name));
    }

    /** Where the card of a mission pad lies on the floor. */
    Optional<Pose> card(int pad) {
      return Optional.ofNullable(cards.get(pad));
    }
  }
}
