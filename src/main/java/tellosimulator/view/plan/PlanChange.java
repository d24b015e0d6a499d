package tellosimulator.view.plan;

import tellosimulator.goal.Goal;
import tellosimulator.math.Vec3;
import tellosimulator.scenario.PlannedDrone;
import tellosimulator.view.plan.PlanItem.GoalItem;
import tellosimulator.view.plan.PlanItem.ObstacleItem;
import tellosimulator.view.plan.PlanItem.Pad;
import tellosimulator.view.plan.PlanItem.Start;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;

/**
 * A plan with a new or changed item. Immutable.
 *
 * @param item the item as numbered in the changed plan; its previous number may have been different
 */
record PlanChange(FloorPlan plan, PlanItem item) {

  static PlanChange adding(Obstacle obstacle, FloorPlan plan) {
    return new PlanChange(plan.with(obstacle), new ObstacleItem(plan.arena().obstacles().size()));
  }

  static PlanChange adding(Goal goal, FloorPlan plan) {
    return new PlanChange(plan.with(goal), new GoalItem(plan.goals().size()));
  }

  static PlanChange adding(MissionPad pad, FloorPlan plan) {
    return new PlanChange(plan.with(pad), new Pad(pad.id()));
  }

  /** Adds a drone with the properties of another one. */
  static PlanChange adding(PlannedDrone like, FloorPlan plan) {
    PlannedDrone drone = new PlannedDrone(like.origin().another(), like.start());
    return new PlanChange(plan.with(drone), new Start(plan.drones().size() + 1));
  }

  /** Returns the plan with the item at another place on the floor, at the same height. */
  FloorPlan at(Vec3 place) {
    return plan.with(item, plan.placement(item).at(place));
  }
}
