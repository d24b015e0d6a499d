package tellosimulator.goal;

import java.util.Optional;
import tellosimulator.goal.Course.Gate;
import tellosimulator.goal.PlacedGoal.Square;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.DroneState;
import tellosimulator.model.FlightPhase;
import tellosimulator.world.MissionPad;

/**
 * The observation of one drone in one step.
 *
 * @param course the course in which the drone flies
 * @param before the state at the end of the previous step
 * @param now the state at the end of the step
 * @param flown whether the drone has flown since the challenge began
 */
record Observation(Course course, DroneState before, DroneState now, boolean flown) {

  /** The vector from the feet to the drone's centre. */
  private static final Vec3 CENTER = Vec3.UP.times(DroneSpec.COLLIDER.height() / 2);

  /**
   * Maximum height of the feet of a drone that stands on a mission pad [m]. Decided: it allows for
   * the thickness of a sheet and for rounding.
   */
  private static final double ON_CARD = 0.01;

  /**
   * Share of the required size from which a target is nearly large enough. Decided: at less than
   * half, the drone is on its way elsewhere.
   */
  private static final double NEARLY = 0.5;

  int drone() {
    return now.drone();
  }

  /**
   * Whether the drone fulfils a goal at this moment. A {@link Goal.Hover} requires this for a
   * period of time.
   */
  boolean reaches(Goal goal) {
    if (goal.drone().isPresent() && goal.drone().getAsInt() != drone()) {
      return false;
    }
    return goal.match(
        new Goal.Cases<>(
            reach -> flies() && reach.region().holds(feet()),
            hover -> flies() && hover.region().holds(feet()),
            pass -> course.gate(pass.gate()).filter(gate -> passes(gate, pass)).isPresent(),
            land -> landed() && land.region().holdsLevel(feet()),
            landOn -> landed() && course.card(landOn.pad()).filter(this::standsOn).isPresent(),
            see -> sight(see) == Sight.FULL));
  }

  /** How a drone sees a target. */
  enum Sight {
    NONE,
    /** All of the target is in the picture, and not much smaller than it must be. */
    SMALL,
    /** All of the target is in the picture, and large enough. */
    FULL
  }

  /** Returns how the drone sees a target at the end of the step. */
  Sight sight(Goal.See see) {
    return sight(see, now);
  }

  /** Returns how the drone saw a target at the end of the previous step. */
  Sight sightBefore(Goal.See see) {
    return sight(see, before);
  }

  private Sight sight(Goal.See see, DroneState drone) {
    Optional<Square> target = course.square(see.target());
    if (target.isEmpty() || !drone.phase().flying()) {
      return Sight.NONE;
    }
    FrontView view = FrontView.of(drone.motion().pose());
    double percent = view.percent(target.get());
    if (percent < see.sizePercent() * NEARLY
        || !course.isVisible(target.get(), view.camera().position())) {
      return Sight.NONE;
    }
    return percent < see.sizePercent() ? Sight.SMALL : Sight.FULL;
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

  /** Whether the drone has landed in this step, after a flight. */
  boolean justLanded() {
    return landed() && before.phase() != FlightPhase.GROUNDED;
  }

  /** Whether the drone was switched off in the air. */
  boolean lostPower() {
    return before.phase().flying() && now.phase() == FlightPhase.OFF;
  }

  private boolean passes(Gate gate, Goal.Pass pass) {
    return crossing(gate)
        .filter(crossing -> crossing.through() && crossing.goes(pass.direction()))
        .isPresent();
  }

  /**
   * Returns the drone's crossing of the plane of a gate's opening in this step, if any. The centre
   * of the drone determines the crossing.
   */
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
   * A crossing of the plane of a gate's opening.
   *
   * @param along whether the direction is along the gate's x axis, not against it
   * @param across the offset from the middle of the opening along the gate's y axis [m]
   * @param up the height above the middle of the opening [m]
   * @param through whether the drone flew through the opening, not past it
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
}
