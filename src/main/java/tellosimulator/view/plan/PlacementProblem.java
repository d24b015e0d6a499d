package tellosimulator.view.plan;

import java.util.List;
import java.util.Optional;
import tellosimulator.goal.Goal;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.view.plan.PlanItem.GoalItem;
import tellosimulator.view.plan.PlanItem.ObstacleItem;
import tellosimulator.view.plan.PlanItem.Pad;
import tellosimulator.view.plan.PlanItem.Start;
import tellosimulator.world.Arena;
import tellosimulator.world.Footprint;
import tellosimulator.world.Obstacle;

/** Why an item cannot stand where it would, or cannot be removed. */
enum PlacementProblem {
  /** Something of it would be outside of the walls. */
  OUTSIDE,
  /** It would reach above the ceiling. */
  TOO_HIGH,
  /** An obstacle would stand where a drone starts. */
  ON_START,
  /** A drone would start in an obstacle. */
  IN_OBSTACLE,
  /** Two drones would start in the same place. */
  ON_DRONE,
  /** It would be gone or have another name, and a goal names it. */
  NAMED_BY_GOAL,
  /** Another obstacle has this name. */
  NAME_TAKEN,
  /** Drones would be other ones or have other numbers, and a fault names one. */
  NAMED_BY_FAULT,
  /** No drone would be left. */
  LAST_DRONE,
  /** There are as many drones as there can be. */
  MOST_DRONES,
  /** Drones or goals would be other ones while a drone flies. */
  WHILE_FLYING;

  /** What may be missing to a gap [m]: the last bits of a calculation. */
  private static final double SLACK = 1e-6;

  /** What keeps an item from where it is; empty if nothing does. */
  static Optional<PlacementProblem> problem(FloorPlan plan, PlanItem item) {
    if (item instanceof ObstacleItem body) {
      return problem(plan, plan.obstacle(body));
    } else if (item instanceof Start start) {
      return problem(plan, start);
    } else if (item instanceof GoalItem goal) {
      return plan.goal(goal) instanceof Goal.InRegion at
              && !Footprint.inside(at.region().place(), plan.arena().room())
          ? Optional.of(OUTSIDE)
          : Optional.empty();
    }
    return Footprint.inside(plan.pad((Pad) item), plan.arena().room())
        ? Optional.empty()
        : Optional.of(OUTSIDE);
  }

  /** Whether a goal could not be reached any more; empty if none is concerned. */
  static Optional<PlacementProblem> problemWithGoals(FloorPlan plan, FloorPlan wanted) {
    return wanted.goals().stream().anyMatch(goal -> plan.offers(goal) && !wanted.offers(goal))
        ? Optional.of(NAMED_BY_GOAL)
        : Optional.empty();
  }

  /**
   * What keeps drones from being taken away; empty if nothing does.
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
