package tellosimulator.view.plan;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.goal.Terms;
import tellosimulator.math.Vec3;
import tellosimulator.view.plan.PlanItem.Pad;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.ObstacleAppearance.Pattern;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;

/** The items of the palette, with initial values that fit into the room. */
enum PaletteItem {
  BOX(0xd9772b, Pattern.PLAIN, room -> new Shape.Box(0.6, 0.6, Math.min(0.6, room.height()))),
  WALL(0xb5654a, Pattern.BRICKS, room -> new Shape.Box(0.1, 1.5, Math.min(1.5, room.height()))),
  CYLINDER(0x2f7fb5, Pattern.PLAIN, room -> new Shape.Cylinder(0.2, Math.min(1, room.height()))),
  RING(0xc8374a, Pattern.STRIPES, room -> ring(room.height())),
  FRAME(0x3a9a5b, Pattern.STRIPES, room -> frame(room.height())),

  /** The mission pad with the lowest free id. */
  PAD(
      false,
      (plan, selected) ->
          plan.freePadIds().stream()
              .findFirst()
              .map(id -> PlanChange.adding(MissionPad.onFloor(id, Vec3.ZERO, 0), plan))),

  REACH(true, goal(plan -> new Goal.Reach(Terms.ANY, inAir(plan)))),
  HOVER(true, goal(plan -> new Goal.Hover(Terms.ANY, inAir(plan), PaletteItem.HOVER_SECONDS))),

  /**
   * A goal at the selected gate, otherwise at the first gate that no goal names, otherwise at the
   * first gate.
   */
  PASS(
      true,
      (plan, selected) ->
          unnamed(GoalPlacement.gates(plan), plan, selected)
              .map(gate -> plan.obstacle(gate).name())
              .map(gate -> new Goal.Pass(Terms.ANY, gate, Goal.Direction.EITHER))
              .map(goal -> PlanChange.adding(goal, plan))),

  LAND(
      true,
      goal(plan -> new Goal.Land(Terms.ANY, new GoalRegion(Vec3.ZERO, GoalRegion.DEFAULT_RADIUS)))),

  /**
   * A goal on the selected mission pad, otherwise on the first pad that no goal names, otherwise on
   * the first pad.
   */
  LAND_ON(
      true,
      (plan, selected) ->
          unnamed(GoalPlacement.pads(plan), plan, selected)
              .map(pad -> new Goal.LandOn(Terms.ANY, pad.id()))
              .map(goal -> PlanChange.adding(goal, plan))),

  /**
   * A goal to see the selected mission pad, otherwise the first poster or pad that no goal asks to
   * see, otherwise the first one.
   */
  SEE(
      true,
      (plan, selected) ->
          unseen(plan, selected)
              .map(target -> new Goal.See(Terms.ANY, target))
              .map(goal -> PlanChange.adding(goal, plan))),

  /** A drone with the properties of the last drone. */
  DRONE(
      false,
      (plan, selected) ->
          Optional.of(PlanChange.adding(plan.drones().get(plan.drones().size() - 1), plan)));

  private static final double GATE_MIDDLE = 1;

  /**
   * Height of a new goal in the air [m]. The drone's feet must reach this height. Decided: a little
   * higher than after a takeoff.
   */
  private static final double GOAL_HEIGHT = 1;

  /** Minimum distance of a new goal from the ceiling [m]. Decided: more than a drone's height. */
  private static final double BELOW_CEILING = 0.3;

  /** Hovering time that a new goal requires [s]. Decided: long enough to be noticed. */
  private static final double HOVER_SECONDS = 3;

  /**
   * Creates the plan with a new item at an arbitrary place; the result is empty if no item of this
   * kind can be added at present.
   */
  private interface Proposal {
    Optional<PlanChange> adding(FloorPlan plan, Optional<PlanItem> selected);
  }

  private final boolean goal;
  private final Proposal proposal;

  PaletteItem(boolean goal, Proposal proposal) {
    this.goal = goal;
    this.proposal = proposal;
  }

  PaletteItem(int rgb, Pattern pattern, Function<Room, Shape> shape) {
    this.goal = false;
    this.proposal =
        (plan, selected) ->
            Optional.of(
                PlanChange.adding(
                    new Obstacle(
                        plan.freeName(word()),
                        shape.apply(plan.arena().room()),
                        Vec3.ZERO,
                        0,
                        new ObstacleAppearance(rgb, pattern, Map.of())),
                    plan));
  }

  private static Proposal goal(Function<FloorPlan, Goal> goal) {
    return (plan, selected) -> Optional.of(PlanChange.adding(goal.apply(plan), plan));
  }

  /** Returns whether the item is a goal. */
  boolean goal() {
    return goal;
  }

  /**
   * Returns the plan with a new item at an arbitrary place; empty if no item of this kind can be
   * added at present.
   *
   * @param selected the item that a new goal names, if possible
   */
  Optional<PlanChange> adding(FloorPlan plan, Optional<PlanItem> selected) {
    return proposal.adding(plan, selected);
  }

  /** Returns the word that begins obstacle names and ends this item's text keys. */
  String word() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  private static Shape ring(double ceiling) {
    double radius = Math.min(0.4, ceiling / 2 - 0.2);
    return new Shape.Ring(radius, 0.05, middle(ceiling, radius + 0.05));
  }

  private static Shape frame(double ceiling) {
    double opening = Math.min(0.8, ceiling - 0.4);
    return new Shape.Frame(0.8, opening, 0.05, middle(ceiling, opening / 2 + 0.05));
  }

  private static double middle(double ceiling, double half) {
    return Math.max(half, Math.min(GATE_MIDDLE, ceiling - half));
  }

  private static GoalRegion inAir(FloorPlan plan) {
    double height = Math.min(GOAL_HEIGHT, plan.arena().room().height() - BELOW_CEILING);
    return new GoalRegion(new Vec3(0, 0, height), GoalRegion.DEFAULT_RADIUS);
  }

  /**
   * Returns the selected item if it is in a list, otherwise the first item of the list that no goal
   * names, otherwise the first item.
   */
  private static <T extends PlanItem> Optional<T> unnamed(
      List<T> items, FloorPlan plan, Optional<PlanItem> selected) {
    List<PlanItem> named =
        plan.goals().stream().flatMap(goal -> GoalPlacement.named(goal, plan).stream()).toList();
    return items.stream()
        .filter(item -> selected.filter(item::equals).isPresent())
        .findFirst()
        .or(() -> items.stream().filter(item -> !named.contains(item)).findFirst())
        .or(() -> items.stream().findFirst());
  }

  private static Optional<Goal.Target> unseen(FloorPlan plan, Optional<PlanItem> selected) {
    List<Goal.Target> targets = List.copyOf(PlacedGoal.targets(plan.arena()).keySet());
    List<Goal.Target> sought =
        plan.goals().stream()
            .filter(Goal.See.class::isInstance)
            .map(goal -> ((Goal.See) goal).target())
            .toList();
    return selected
        .filter(Pad.class::isInstance)
        .<Goal.Target>map(pad -> new Goal.NumberedPad(((Pad) pad).id()))
        .or(() -> targets.stream().filter(target -> !sought.contains(target)).findFirst())
        .or(() -> targets.stream().findFirst());
  }
}
