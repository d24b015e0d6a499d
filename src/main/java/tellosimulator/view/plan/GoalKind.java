package tellosimulator.view.plan;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.math.Vec3;
import tellosimulator.view.plan.PlanItem.ObstacleItem;
import tellosimulator.view.plan.PlanItem.Pad;
import tellosimulator.world.Shape;

/** The goals of the palette, each as one needs it most. */
enum GoalKind {
  REACH {
    @Override
    Optional<Goal> goal(FloorPlan plan, Optional<PlanItem> selected) {
      return Optional.of(new Goal.Reach(ANY, region(plan)));
    }
  },
  HOVER {
    @Override
    Optional<Goal> goal(FloorPlan plan, Optional<PlanItem> selected) {
      return Optional.of(new Goal.Hover(ANY, region(plan), SECONDS));
    }
  },
  /** Through the selected gate, or the first one that no goal names. */
  PASS {
    @Override
    Optional<Goal> goal(FloorPlan plan, Optional<PlanItem> selected) {
      Optional<ObstacleItem> chosen =
          selected
              .filter(ObstacleItem.class::isInstance)
              .map(ObstacleItem.class::cast)
              .filter(item -> plan.obstacle(item).shape() instanceof Shape.Gate);
      return chosen
          .or(() -> firstUnnamed(GoalPlacement.gates(plan), plan))
          .map(gate -> new Goal.Pass(ANY, plan.obstacle(gate).name(), Goal.Direction.EITHER));
    }
  },
  LAND {
    @Override
    Optional<Goal> goal(FloorPlan plan, Optional<PlanItem> selected) {
      return Optional.of(new Goal.Land(ANY, new GoalRegion(Vec3.ZERO, RADIUS)));
    }
  },
  /** On the selected mission pad, or the first one that no goal names. */
  LAND_ON {
    @Override
    Optional<Goal> goal(FloorPlan plan, Optional<PlanItem> selected) {
      List<Pad> pads = GoalPlacement.pads(plan);
      Optional<Pad> chosen = selected.filter(pads::contains).map(Pad.class::cast);
      return chosen.or(() -> firstUnnamed(pads, plan)).map(pad -> new Goal.LandOn(ANY, pad.id()));
    }
  };

  private static final OptionalInt ANY = OptionalInt.empty();

  /** Radius [m]. Decided: that of scenario files that say none. */
  private static final double RADIUS = 0.3;

  /** Height of the feet [m]. Decided: a little above that of a takeoff. */
  private static final double HEIGHT = 1;

  /** What is left free below the ceiling [m]. Decided: more than a drone is high. */
  private static final double BELOW_CEILING = 0.3;

  /** Time to hover [s]. Decided: long enough to be seen. */
  private static final double SECONDS = 3;

  /**
   * A goal for any drone; one with a place of its own in the middle of the floor.
   *
   * @param selected which it is about, if it can be
   * @return empty if there is nothing that it could name
   */
  abstract Optional<Goal> goal(FloorPlan plan, Optional<PlanItem> selected);

  /** The end of the keys of its texts. */
  String word() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  private static GoalRegion region(FloorPlan plan) {
    double height = Math.min(HEIGHT, plan.arena().room().height() - BELOW_CEILING);
    return new GoalRegion(new Vec3(0, 0, height), RADIUS);
  }

  private static <T extends PlanItem> Optional<T> firstUnnamed(List<T> items, FloorPlan plan) {
    List<PlanItem> named =
        plan.goals().stream().flatMap(goal -> GoalPlacement.named(goal, plan).stream()).toList();
    return items.stream()
        .filter(item -> !named.contains(item))
        .findFirst()
        .or(() -> items.stream().findFirst());
  }
}
