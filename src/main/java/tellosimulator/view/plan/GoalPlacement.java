package tellosimulator.view.plan;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.math.Vec3;
import tellosimulator.view.plan.PlanItem.ObstacleItem;
import tellosimulator.view.plan.PlanItem.Pad;
import tellosimulator.world.Shape;

/** Placement of goals seen from above: at a place of their own, or at the gate or pad they name. */
final class GoalPlacement {

  private GoalPlacement() {}

  /** The gates of a plan, in the order of their numbers. */
  static List<ObstacleItem> gates(FloorPlan plan) {
    return IntStream.range(0, plan.arena().obstacles().size())
        .mapToObj(ObstacleItem::new)
        .filter(item -> plan.obstacle(item).shape() instanceof Shape.Gate)
        .toList();
  }

  /** The mission pads on which one can land. */
  static List<Pad> pads(FloorPlan plan) {
    return plan.arena().pads().stream()
        .filter(pad -> !pad.surface().wall())
        .map(pad -> new Pad(pad.id()))
        .toList();
  }

  /**
   * The gate or the pad that a goal names; empty for one at a place of its own, or if it is gone.
   */
  static Optional<PlanItem> named(Goal goal, FloorPlan plan) {
    if (goal instanceof Goal.Pass pass) {
      return gates(plan).stream()
          .filter(gate -> plan.obstacle(gate).name().equals(pass.gate()))
          .map(PlanItem.class::cast)
          .findFirst();
    }
    return goal instanceof Goal.LandOn land
        ? Optional.<PlanItem>of(new Pad(land.pad())).filter(plan::has)
        : Optional.empty();
  }

  /** Where a goal is. */
  static Placement placement(Goal goal, FloorPlan plan) {
    return goal instanceof Goal.InRegion at
        ? new Placement(at.region().place(), 0)
        : named(goal, plan).map(plan::placement).orElse(new Placement(Vec3.ZERO, 0));
  }

  /** What a goal covers of the floor. */
  static PlanOutline outline(Goal goal, FloorPlan plan) {
    return goal instanceof Goal.InRegion at
        ? PlanOutline.circle(at.region().radius())
        : named(goal, plan).map(plan::outline).orElse(PlanOutline.circle(0));
  }

  /** A goal that has a place of its own, elsewhere; another one stays where it is. */
  static Goal moved(Goal goal, Vec3 place) {
    return goal instanceof Goal.InRegion at
        ? at.at(new GoalRegion(place, at.region().radius()))
        : goal;
  }

  /** A goal that names a gate or a pad, at the one that is nearest to a place. */
  static Goal renamed(Goal goal, Vec3 place, FloorPlan plan) {
    Stream<? extends PlanItem> others =
        goal instanceof Goal.Pass ? gates(plan).stream() : pads(plan).stream();
    return others
        .min(
            Comparator.comparingDouble(
                item -> plan.placement(item).place().minus(place).horizontal().norm()))
        .map(item -> naming(goal, item, plan))
        .orElse(goal);
  }

  /** The same goal at another gate or pad; itself if it cannot be there. */
  static Goal naming(Goal goal, PlanItem item, FloorPlan plan) {
    if (goal instanceof Goal.Pass pass && item instanceof ObstacleItem gate) {
      return new Goal.Pass(pass.drone(), plan.obstacle(gate).name(), pass.direction());
    }
    return goal instanceof Goal.LandOn land && item instanceof Pad pad
        ? new Goal.LandOn(land.drone(), pad.id())
        : goal;
  }
}
