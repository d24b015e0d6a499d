package tellosimulator.goal;

import tellosimulator.goal.Course.Gate;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.DroneState;
import tellosimulator.model.FlightPhase;
import tellosimulator.world.MissionPad;

/**
 * What is seen of a drone in one step.
 *
 * @param course in which it flies
 * @param before at the end of the step before
 * @param now at the end of the step
 * @param flown whether it has flown since the challenge began
 */
record Sight(Course course, DroneState before, DroneState now, boolean flown) {

  /** From the feet to the drone's centre. */
  private static final Vec3 CENTRE = Vec3.UP.times(DroneSpec.HULL.height() / 2);

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
      return flies() && reach.spot().holds(feet());
    }
    if (goal instanceof Goal.Hover hover) {
      return flies() && hover.spot().holds(feet());
    }
    if (goal instanceof Goal.Pass pass) {
      return flies()
          && course.gate(pass.gate()).filter(gate -> passes(gate, pass.direction())).isPresent();
    }
    if (goal instanceof Goal.Land land) {
      return landed() && land.spot().holdsLevel(feet());
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

  private boolean passes(Gate gate, Goal.Direction direction) {
    Vec3 from = inFrame(gate, before);
    Vec3 to = inFrame(gate, now);
    boolean along = from.x() < 0 && to.x() >= 0;
    boolean against = from.x() > 0 && to.x() <= 0;
    boolean crosses =
        switch (direction) {
          case EITHER -> along || against;
          case ALONG -> along;
          case AGAINST -> against;
        };
    if (!crosses) {
      return false;
    }
    Vec3 crossing = from.plusScaled(to.minus(from), from.x() / (from.x() - to.x()));
    return gate.opening().opens(crossing.y(), crossing.z() - gate.opening().middle());
  }

  private static Vec3 inFrame(Gate gate, DroneState drone) {
    Vec3 centre = drone.motion().position().plus(CENTRE);
    return gate.pose().attitude().toBody(centre.minus(gate.pose().position()));
  }

  private boolean standsOn(Pose card) {
    Vec3 offset = card.attitude().toBody(feet().minus(card.position()));
    return Math.abs(offset.x()) <= MissionPad.EDGE / 2
        && Math.abs(offset.y()) <= MissionPad.EDGE / 2
        && offset.z() <= ON_CARD;
  }
}
