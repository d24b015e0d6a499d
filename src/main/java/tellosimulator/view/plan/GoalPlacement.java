package tellosimulator.view.plan;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.math.Vec3;
import tellosimulator.view.plan.PlanItem.ObstacleItem;
import tellosimulator.view.plan.PlanItem.Pad;
import tellosimulator.world.Arena;
import tellosimulator.world.Shape;

/**
 * Computes the placement of goals, seen from above. A goal either has its own position, or is
 * placed at the gate, pad or poster that it names.
 */
final class GoalPlacement {

  private GoalPlacement() {}

  /** Returns the gates of a plan, in the order of its obstacles. */
  static List<ObstacleItem> gates(FloorPlan plan) {
    return IntStream.range(0, plan.arena().obstacles().size())
        .mapToObj(ObstacleItem::new)
        .filter(item -> plan.obstacle(item).shape() instanceof Shape.Gate)
        .toList();
  }

  /** Returns the mission pads that drones can land on. */
  static List<Pad> pads(FloorPlan plan) {
    return plan.arena().pads().stream()
        .filter(pad -> !pad.surface().wall())
        .map(pad -> new Pad(pad.id()))
        .toList();
  }

  /**
   * Returns the gate or pad that a goal names; empty if the goal has its own position or names a
   * poster, or if the named item does not exist.
   */
  static Optional<PlanItem> named(Goal goal, FloorPlan plan) {
    if (goal instanceof Goal.Pass pass) {
      return gates(plan).stream()
          .filter(gate -> plan.obstacle(gate).name().equals(pass.gate()))
          .map(PlanItem.class::cast)
          .findFirst();
    }
    Optional<PlanItem> pad = Optional.empty();
    if (goal instanceof Goal.LandOn land) {
      pad = Optional.of(new Pad(land.pad()));
    } else if (goal instanceof Goal.See see && see.target() instanceof Goal.NumberedPad numbered) {
      pad = Optional.of(new Pad(numbered.pad()));
    }
    return pad.filter(plan::has);
  }

  /** Returns the placement of a goal. */
  static Placement placement(Goal goal, FloorPlan plan) {
    return goal instanceof Goal.InRegion at
        ? new Placement(at.region().place(), 0)
        : named(goal, plan).map(plan::placement).orElseGet(() -> onSide(goal, plan.arena()));
  }

  /** Returns the placement of a goal that names a poster. */
  private static Placement onSide(Goal goal, Arena arena) {
    return PlacedGoal.places(List.of(goal), arena).stream()
        .findFirst()
        .map(place -> new Placement(place.middle(), 0))
        .orElse(new Placement(Vec3.ZERO, 0));
  }

  /** Returns the outline of a goal on the floor. */
  static PlanOutline outline(Goal goal, FloorPlan plan) {
    return goal instanceof Goal.InRegion at
        ? PlanOutline.circle(at.region().radius())
        : named(goal, plan).map(plan::outline).orElse(PlanOutline.circle(0));
  }

  /** Returns a goal moved to a place. Goals that name a gate or pad are returned unchanged. */
  static Goal moved(Goal goal, Vec3 place) {
    return goal instanceof Goal.InRegion at
        ? at.at(new GoalRegion(place, at.region().radius()))
        : goal;
  }

  /** Returns a goal that names the object nearest to a place, instead of the previous one. */
  static Goal renamed(Goal goal, Vec3 place, FloorPlan plan) {
    if (goal instanceof Goal.See see) {
      return PlacedGoal.targets(plan.arena()).entrySet().stream()
          .min(
              Comparator.comparingDouble(
                  target -> target.getValue().middle().minus(place).horizontal().norm()))
          .<Goal>map(target -> see.of(target.getKey()))
          .orElse(goal);
    }
    List<? extends PlanItem> others = goal instanceof Goal.Pass ? gates(plan) : pads(plan);
    return others.stream()
        .min(
            Comparator.comparingDouble(
                item -> plan.placement(item).place().minus(place).horizontal().norm()))
        .map(item -> naming(goal, item, plan))
        .orElse(goal);
  }

  /**
   * Returns a goal that names another gate or pad. A goal that cannot name an item of that kind is
   * returned unchanged.
   */
  static Goal naming(Goal goal, PlanItem item, FloorPlan plan) {
    if (goal instanceof Goal.Pass pass && item instanceof ObstacleItem gate) {
      return new Goal.Pass(pass.terms(), plan.obstacle(gate).name(), pass.direction());
    }
    return goal instanceof Goal.LandOn land && item instanceof Pad pad
        ? new Goal.LandOn(land.terms(), pad.id())
        : goal;
  }
}
