package tellosimulator.view.plan;

import java.util.List;
import java.util.Optional;
import tellosimulator.goal.Goal;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.view.plan.PlanItem.Start;
import tellosimulator.world.Arena;
import tellosimulator.world.Footprint;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Room;

/** The reason why an item cannot be placed or removed. */
enum PlacementProblem {
  /** Part of the item would be outside the walls. */
  OUTSIDE,
  /** The top of the obstacle would be above the ceiling. */
  TOO_HIGH,
  /** An obstacle would cover a drone's start. */
  ON_START,
  /** A drone would start in an obstacle. */
  IN_OBSTACLE,
  /** Two drones would overlap at their starts. */
  ON_DRONE,
  /** The item would be removed or renamed, but a goal names it. */
  NAMED_BY_GOAL,
  /** Another obstacle already has this name. */
  NAME_TAKEN,
  /** Drones would be removed or renumbered, but a fault names one of them. */
  NAMED_BY_FAULT,
  /** No drone would remain. */
  LAST_DRONE,
  /** The maximum number of drones is reached. */
  MOST_DRONES,
  /** Drones or goals would change while a drone is flying. */
  WHILE_FLYING;

  /** Tolerance for rounding errors in the distance between two drones [m]. */
  private static final double SLACK = 1e-6;

  /** Returns the reason why an item cannot be at its place; empty if it can. */
  static Optional<PlacementProblem> problem(FloorPlan plan, PlanItem item) {
    Room room = plan.arena().room();
    return item.match(
        start -> problem(plan, start),
        pad -> outside(Footprint.inside(plan.pad(pad), room)),
        obstacle -> problem(plan, plan.obstacle(obstacle)),
        goal ->
            outside(
                !(plan.goal(goal) instanceof Goal.InRegion at)
                    || Footprint.inside(at.region().place(), room)));
  }

  private static Optional<PlacementProblem> outside(boolean inside) {
    return inside ? Optional.empty() : Optional.of(OUTSIDE);
  }

  /** Returns a problem if a gate or pad that a goal names would disappear; empty otherwise. */
  static Optional<PlacementProblem> problemWithGoals(FloorPlan plan, FloorPlan wanted) {
    return wanted.goals().stream().anyMatch(goal -> plan.offers(goal) && !wanted.offers(goal))
        ? Optional.of(NAMED_BY_GOAL)
        : Optional.empty();
  }

  /**
   * Returns the reason why drones cannot be removed; empty if they can.
   *
   * @param faulty whether a fault names a drone by its number
   */
  static Optional<PlacementProblem> problemWithout(
      FloorPlan plan, List<PlanItem> drones, boolean faulty) {
    if (drones.isEmpty()) {
      return Optional.empty();
    } else if (drones.size() == plan.drones().size()) {
      return Optional.of(LAST_DRONE);
    } else if (faulty) {
      return Optional.of(NAMED_BY_FAULT);
    }
    boolean named =
        plan.goals().stream()
            .flatMapToInt(goal -> goal.drone().stream())
            .anyMatch(number -> drones.contains(new Start(number)));
    return named ? Optional.of(NAMED_BY_GOAL) : Optional.empty();
  }

  private static Optional<PlacementProblem> problem(FloorPlan plan, Obstacle obstacle) {
    Arena arena = plan.arena();
    if (!Footprint.betweenWalls(obstacle, arena.room())) {
      return Optional.of(OUTSIDE);
    }
    if (!Footprint.underCeiling(obstacle, arena.room())) {
      return Optional.of(TOO_HIGH);
    }
    return plan.starts().stream()
            .anyMatch(start -> obstacle.intersects(start.position(), DroneSpec.COLLIDER))
        ? Optional.of(ON_START)
        : Optional.empty();
  }

  private static Optional<PlacementProblem> problem(FloorPlan plan, Start start) {
    Vec3 place = plan.placement(start).place();
    if (!plan.arena().room().contains(place, DroneSpec.COLLIDER)) {
      return Optional.of(OUTSIDE);
    }
    if (plan.arena().obstacles().stream()
        .anyMatch(obstacle -> obstacle.intersects(place, DroneSpec.COLLIDER))) {
      return Optional.of(IN_OBSTACLE);
    }
    for (int drone = 1; drone <= plan.starts().size(); drone++) {
      Vec3 other = plan.starts().get(drone - 1).position();
      if (drone != start.drone()
          && place.distanceTo(other) < 2 * DroneSpec.COLLIDER.radius() - SLACK) {
        return Optional.of(ON_DRONE);
      }
    }
    return Optional.empty();
  }
}
