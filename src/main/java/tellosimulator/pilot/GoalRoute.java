package tellosimulator.pilot;

import java.util.List;
import java.util.Optional;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.FrontView;
import tellosimulator.goal.Goal;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.profile.Behavior;
import tellosimulator.sim.FreeSpace;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;

/**
 * Plans the commands with which one drone reaches the goals of a scenario. The drone flies straight
 * from goal to goal; if obstacles are in the way, it flies up, over them, and down again. It does
 * not search for routes around obstacles.
 */
public final class GoalRoute {

  /** Additional height of each further attempt to fly over an obstacle [m]. */
  private static final double HIGHER = 0.1;

  /**
   * Height above a landing place at which the landing begins [m]. It must be at least 0.2 m, the
   * shortest {@code go}, but low enough that the wind has little time to act.
   */
  private static final double FINAL_APPROACH = 0.5;

  /**
   * Distance from a gate's opening to the points before and behind it at which a pass begins and
   * ends [m]. Decided: clear of the frame.
   */
  private static final double GATE_LEAD = 0.5;

  /** Height above a landing place down to which the descent must be free of obstacles [m]. */
  private static final double LAST_AIR = 0.12;

  /**
   * Drift during a landing for each m/s of wind [s]. Measured in the simulation at 6 m/s: 24 cm.
   */
  private static final double LANDING_DRIFT = 0.040;

  /**
   * Like {@link #LANDING_DRIFT}, but for the reference model of measured drones [s]. Drones of this
   * model take longer to settle. Measured in the simulation at 6 m/s: 74 cm.
   */
  private static final double LANDING_DRIFT_MEASURED = 0.122;

  /**
   * Allowed error of the plan as a fraction of a goal's radius. Decided: the rest is left for
   * errors of the flight.
   */
  private static final double ACCURACY = 0.5;

  /**
   * Maximum distance from which the drone looks at a square [m]. Decided: what it does is still
   * obvious to people.
   */
  private static final double FARTHEST_VIEW = 2.5;

  /**
   * Size of a square in the picture, as a multiple of the required one. Decided: the rest is left
   * for errors of the flight, and for views from the side.
   */
  private static final double LARGER = 1.25;

  /** Maximum size of a square in the picture [percent]. Decided: it is all in the picture. */
  private static final double LARGEST_VIEW = 66;

  /** Angle by which the camera looks down on a square on the floor [rad]. Decided. */
  private static final double ONTO_FLOOR = DroneSpec.CAMERA_TILT + StrictMath.toRadians(8);

  /** Minimum distance of a view from floor and ceiling [m]. Decided: clear of both. */
  private static final double VIEW_MARGIN = 0.3;

  /**
   * Length of the line of sight in front of a square that is not tested [m]. Decided: a drone fits
   * in there.
   */
  private static final double BEFORE_SQUARE = 0.25;

  /** Directions from which the drone tries to look at a square, relative to the best [degrees]. */
  private static final int[] ASIDE_DEG = {0, 30, -30, 50, -50, 90, -90, 135, -135, 180};

  /** Turn to the right and back while the drone looks at a square [degrees]. Decided: visible. */
  private static final int GLANCE_DEG = 5;

  /** Minimum duration of such a turn to the right and back [s]. Measured in the simulation: 1 s. */
  private static final double GLANCE = 1;

  /** A full turn [deg]. */
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
   * Returns the commands from {@code command} to {@code land}; empty if the drone has no goal to
   * reach, if it would have to wait for another drone, or if no route is found.
   *
   * @param number the number of a standing drone, from 1
   */
  public static Optional<List<String>> commands(
      Challenge challenge, SimSnapshot snapshot, int number) {
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
      List<PlacedGoal.Place> places = PlacedGoal.places(List.of(goal), snapshot.arena());
      possible &= !places.isEmpty();
      places.forEach(place -> reach(place, goal));
    }
    if (!plan.landed()) {
      plan.say("land");
    }
    return possible ? Optional.of(plan.commands()) : Optional.empty();
  }

  private void reach(PlacedGoal.Place place, Goal goal) {
    if (place instanceof PlacedGoal.Ball ball) {
      flyTo(ball.middle(), ball.radius() * ACCURACY);
      stay(goal.lasting());
    } else if (place instanceof PlacedGoal.Circle circle) {
      double drift = behavior == Behavior.REPORT ? LANDING_DRIFT : LANDING_DRIFT_MEASURED;
      Vec3 upwind = snapshot.arena().wind().mean().times(-drift);
      Vec3 above = circle.middle().plus(upwind).plusScaled(Vec3.UP, FINAL_APPROACH);
      flyTo(above, circle.radius() * ACCURACY);
      possible &= space.holds(List.of(above, circle.middle().plusScaled(Vec3.UP, LAST_AIR)));
      plan.landOn(circle.middle());
    } else if (place instanceof PlacedGoal.Opening opening) {
      pass(opening);
    } else if (place instanceof PlacedGoal.Square square && goal instanceof Goal.See see) {
      look(square, see);
    }
  }

  /** Looks at a square, from the first direction that has a free line of sight. */
  private void look(PlacedGoal.Square square, Goal.See see) {
    Vec3 level = square.out().horizontal();
    boolean hangs = level.norm() > 0.5;
    Vec3 here = plan.position().minus(square.middle()).horizontal();
    Vec3 best = (hangs ? level : here).normalized();
    double shown = Math.min(LARGEST_VIEW, LARGER * see.sizePercent());
    double distance = Math.min(FARTHEST_VIEW, FrontView.distance(square.edge(), shown));
    double down = hangs ? DroneSpec.CAMERA_TILT : ONTO_FLOOR;
    double highest = snapshot.room().height() - VIEW_MARGIN;
    Optional<FlightPlan> found = Optional.empty();
    for (int i = 0; i < ASIDE_DEG.length && found.isEmpty(); i++) {
      Vec3 back = best.turned(StrictMath.toRadians(ASIDE_DEG[i]));
      Vec3 place =
          square
              .middle()
              .plusScaled(back, distance * StrictMath.cos(down) + DroneSpec.CAMERA_PLACE.x())
              .plusScaled(Vec3.UP, distance * StrictMath.sin(down) - DroneSpec.CAMERA_PLACE.z());
      double height = Math.max(VIEW_MARGIN, Math.min(highest, place.z()));
      found =
          way(place.withZ(height), GATE_LEAD / 2)
              .map(end -> end.turnTo(square.middle()))
              .filter(end -> FrontView.of(end.pose()).percent(square) >= see.sizePercent())
              .filter(end -> space.holds(List.of(end.position(), before(square))));
    }
    found.ifPresent(end -> plan = end);
    possible &= found.isPresent();
    for (double left = see.seconds(); left > 0; left -= GLANCE) {
      plan.clockwise(GLANCE_DEG).clockwise(-GLANCE_DEG);
    }
  }

  private static Vec3 before(PlacedGoal.Square square) {
    Vec3 place = square.middle().plusScaled(square.out(), BEFORE_SQUARE);
    return place.withZ(Math.max(LAST_AIR, place.z()));
  }

  private void pass(PlacedGoal.Opening opening) {
    Vec3 along = opening.pose().attitude().toRoom(new Vec3(1, 0, 0));
    Vec3 middle = opening.middle().plusScaled(Vec3.UP, -DroneSpec.COLLIDER.height() / 2);
    boolean before = plan.position().minus(middle).dot(along) < 0;
    Vec3 way = opening.way().orElse(before ? along : along.times(-1));
    flyTo(middle.plusScaled(way, -GATE_LEAD), GATE_LEAD / 2);
    flyTo(middle.plusScaled(way, GATE_LEAD), GATE_LEAD / 2);
  }

  /**
   * Hovers for at least the given time [s], by making full turns on the spot, so that the hovering
   * is visible.
   */
  private void stay(double seconds) {
    double left = seconds;
    while (left > 0) {
      plan.clockwise(FULL_TURN);
      left -= StrictMath.toRadians(FULL_TURN) / DroneSpec.TURN_RATE;
    }
  }

  private void flyTo(Vec3 place, double tolerance) {
    Optional<FlightPlan> way = way(place, tolerance);
    way.ifPresent(found -> plan = found);
    possible &= way.isPresent();
  }

  /**
   * Returns the plan with a way to a place: straight if possible, and otherwise over the obstacles,
   * as low as possible.
   */
  private Optional<FlightPlan> way(Vec3 place, double tolerance) {
    Optional<FlightPlan> way =
        free(plan.copy().goTo(place)).filter(end -> isNear(end, place, tolerance));
    double top = snapshot.room().height() - DroneSpec.COLLIDER.height();
    double height = Math.max(plan.position().z(), place.z());
    while (way.isEmpty() && height <= top) {
      way = free(over(height, place)).filter(end -> isNear(end, place, tolerance));
      height += HIGHER;
    }
    return way;
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
