package tellosimulator.view.pilot;

import java.util.List;
import java.util.Optional;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalMark;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.profile.Behavior;
import tellosimulator.sim.FreeSpace;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;

/**
 * Which commands let one drone reach the goals of a scenario. It flies straight from goal to goal,
 * or up, over what is in the way, and down. It does not look for ways around things.
 */
final class GoalRoute {

  /** How much higher the next try flies over what is in the way [m]. */
  private static final double HIGHER = 0.1;

  /**
   * Height above a landing place from which it lands [m]: a go needs 20 cm, and wind has little
   * time.
   */
  private static final double FINAL_APPROACH = 0.5;

  /**
   * How far before and behind an opening a pass begins and ends [m]. Decided: clear of the frame.
   */
  private static final double GATE_LEAD = 0.5;

  /** Height above a landing place down to which its air must be free [m]. */
  private static final double LAST_AIR = 0.12;

  /**
   * How far the wind carries a drone while it lands, for each m/s [s]. Measured in the simulation:
   * 24 cm at 6 m/s, and 74 cm with the longer settling of measured drones.
   */
  private static final double LANDING_DRIFT = 0.040;

  private static final double LANDING_DRIFT_MEASURED = 0.122;

  /** Share of a goal's radius that a plan may be off. Decided: the rest is for the flight. */
  private static final double ACCURACY = 0.5;

  /** A turn after which the nose points where it did [degrees]. */
  private static final int FULL_TURN = 360;

  private final SimSnapshot snapshot;
  private final FreeSpace space;
  private final Behavior behavior;
  private FlightPlan plan;
  private boolean possible = true;

  private GoalRoute(SimSnapshot snapshot, DroneSnapshot drone) {
    this.snapshot = snapshot;
    this.space = new FreeSpace(snapshot, drone.state().drone());
    this.behavior = drone.product().behavior();
    this.plan = FlightPlan.from(drone.state().motion().pose());
  }

  /**
   * From {@code command} to {@code land}; empty if there is nothing for the drone to reach, or no
   * way that this class finds.
   *
   * @param number of a drone that stands, from 1
   */
  static Optional<List<String>> commands(Challenge challenge, SimSnapshot snapshot, int number) {
    List<Goal> goals =
        challenge.goals().stream().filter(goal -> goal.drone().orElse(number) == number).toList();
    boolean waits = challenge.inOrder() && goals.size() < challenge.goals().size();
    if (goals.isEmpty() || waits) {
      return Optional.empty();
    }
    return new GoalRoute(snapshot, snapshot.drones().get(number - 1)).through(goals);
  }

  private Optional<List<String>> through(List<Goal> goals) {
    plan.say("command");
    for (Goal goal : goals) {
      if (plan.landed()) {
        plan.takeoff(behavior.takeoffHeight() + behavior.takeoffCreep());
      }
      List<GoalMark.Place> places = GoalMark.places(List.of(goal), snapshot.arena());
      possible &= !places.isEmpty();
      places.forEach(place -> reach(place, goal));
    }
    if (!plan.landed()) {
      plan.say("land");
    }
    return possible ? Optional.of(plan.commands()) : Optional.empty();
  }

  private void reach(GoalMark.Place place, Goal goal) {
    if (place instanceof GoalMark.Ball ball) {
      flyTo(ball.middle(), ball.radius() * ACCURACY);
      stay(goal.lasting());
    } else if (place instanceof GoalMark.Circle circle) {
      double drift = behavior == Behavior.REPORT ? LANDING_DRIFT : LANDING_DRIFT_MEASURED;
      Vec3 upwind = snapshot.arena().wind().mean().times(-drift);
      Vec3 above = circle.middle().plus(upwind).plusScaled(Vec3.UP, FINAL_APPROACH);
      flyTo(above, circle.radius() * ACCURACY);
      possible &= space.holds(List.of(above, circle.middle().plusScaled(Vec3.UP, LAST_AIR)));
      plan.landOn(circle.middle());
    } else if (place instanceof GoalMark.Opening opening) {
      pass(opening);
    }
  }

  private void pass(GoalMark.Opening opening) {
    Vec3 along = opening.pose().attitude().toRoom(new Vec3(1, 0, 0));
    Vec3 middle = opening.middle().plusScaled(Vec3.UP, -DroneSpec.COLLIDER.height() / 2);
    boolean before = plan.position().minus(middle).dot(along) < 0;
    Vec3 way = opening.way().orElse(before ? along : along.times(-1));
    flyTo(middle.plusScaled(way, -GATE_LEAD), GATE_LEAD / 2);
    flyTo(middle.plusScaled(way, GATE_LEAD), GATE_LEAD / 2);
  }

  /** Turns on the spot, by which one sees that it is there. */
  private void stay(double seconds) {
    double left = seconds;
    while (left > 0) {
      plan.clockwise(FULL_TURN);
      left -= StrictMath.toRadians(FULL_TURN) / DroneSpec.TURN_RATE;
    }
  }

  /** To a place, straight or over what is in the way, as low as there is a way. */
  private void flyTo(Vec3 place, double tolerance) {
    Optional<FlightPlan> way =
        free(plan.copy().goTo(place)).filter(end -> isNear(end, place, tolerance));
    double top = snapshot.room().height() - DroneSpec.COLLIDER.height();
    double height = Math.max(plan.position().z(), place.z());
    while (way.isEmpty() && height <= top) {
      way = free(over(height, place)).filter(end -> isNear(end, place, tolerance));
      height += HIGHER;
    }
    way.ifPresent(found -> plan = found);
    possible &= way.isPresent();
  }

  private FlightPlan over(double height, Vec3 place) {
    return plan.copy().goTo(plan.position().withZ(height)).goTo(place.withZ(height)).goTo(place);
  }

  private Optional<FlightPlan> free(FlightPlan way) {
    return space.holds(way.path()) ? Optional.of(way) : Optional.empty();
  }

  private static boolean isNear(FlightPlan end, Vec3 place, double tolerance) {
    return end.position().distanceTo(place) <= tolerance;
  }
}
