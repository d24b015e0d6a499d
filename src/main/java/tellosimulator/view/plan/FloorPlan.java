package tellosimulator.view.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.math.Pose;
import tellosimulator.scenario.DroneOrigin;
import tellosimulator.scenario.PlannedDrone;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.view.plan.PlanItem.GoalItem;
import tellosimulator.view.plan.PlanItem.ObstacleItem;
import tellosimulator.view.plan.PlanItem.Pad;
import tellosimulator.view.plan.PlanItem.Start;
import tellosimulator.world.Arena;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleNames;

/**
 * Everything that can be placed in a room, with its positions. Immutable.
 *
 * @param arena the room with obstacles and mission pads
 * @param drones the drones in the order of their numbers
 * @param challenge the goals of the drones
 */
record FloorPlan(Arena arena, List<PlannedDrone> drones, Challenge challenge) {

  FloorPlan {
    drones = List.copyOf(drones);
  }

  /**
   * Returns the floor plan of a simulation.
   *
   * @param origins the origins of the drones, in the order of their numbers
   */
  static FloorPlan of(SimSnapshot snapshot, List<DroneOrigin> origins, Challenge challenge) {
    List<PlannedDrone> drones = new ArrayList<>();
    for (DroneSnapshot drone : snapshot.drones()) {
      drones.add(new PlannedDrone(origins.get(drones.size()), drone.start()));
    }
    return new FloorPlan(snapshot.arena(), drones, challenge);
  }

  /** Returns the starting poses of the drones, in the order of their numbers. */
  List<Pose> starts() {
    return drones.stream().map(PlannedDrone::start).toList();
  }

  /** Returns the origins of the drones, in the order of their numbers. */
  List<DroneOrigin> origins() {
    return drones.stream().map(PlannedDrone::origin).toList();
  }

  List<Goal> goals() {
    return challenge.goals();
  }

  /** Returns all items in drawing order: later items are drawn over earlier ones. */
  List<PlanItem> items() {
    Stream<PlanItem> pads = arena.pads().stream().map(pad -> new Pad(pad.id()));
    Stream<PlanItem> things =
        IntStream.range(0, arena.obstacles().size()).mapToObj(ObstacleItem::new);
    Stream<PlanItem> all = IntStream.rangeClosed(1, drones.size()).mapToObj(Start::new);
    Stream<PlanItem> asked = IntStream.range(0, goals().size()).mapToObj(GoalItem::new);
    return Stream.of(asked, pads, things, all).flatMap(items -> items).toList();
  }

  /** Returns whether the plan contains an item. */
  boolean has(PlanItem item) {
    return item.match(
        start -> start.drone() <= drones.size(),
        pad -> pad(pad.id()).isPresent(),
        obstacle -> obstacle.index() < arena.obstacles().size(),
        goal -> goal.index() < goals().size());
  }

  /** Returns whether the object that a goal names is in the plan; true if the goal names none. */
  boolean offers(Goal goal) {
    if (goal instanceof Goal.Pass pass) {
      return names().contains(pass.gate());
    } else if (goal instanceof Goal.See see) {
      return PlacedGoal.targets(arena).containsKey(see.target());
    }
    return !(goal instanceof Goal.LandOn land) || pad(land.pad()).isPresent();
  }

  /** Returns whether an item is a goal that names an object instead of having its own position. */
  boolean namesAnother(PlanItem item) {
    return item instanceof GoalItem goal && !(goal(goal) instanceof Goal.InRegion);
  }

  /**
   * Returns the placement of an item. The heading of a hanging mission pad points from the wall
   * into the room.
   */
  Placement placement(PlanItem item) {
    return item.match(
        start -> Placement.of(drone(start).start()),
        pad -> PadPlacement.placement(pad(pad), arena.room()),
        obstacle -> new Placement(obstacle(obstacle).foot(), obstacle(obstacle).heading()),
        goal -> GoalPlacement.placement(goal(goal), this));
  }

  /** Returns the outline of an item on the floor. */
  PlanOutline outline(PlanItem item) {
    return item.match(
        start -> PlanOutline.ofDrone(),
        pad -> PlanOutline.of(pad(pad)),
        obstacle -> PlanOutline.of(obstacle(obstacle).shape()),
        goal -> GoalPlacement.outline(goal(goal), this));
  }

  Obstacle obstacle(ObstacleItem item) {
    return arena.obstacles().get(item.index());
  }

  Goal goal(GoalItem item) {
    return goals().get(item.index());
  }

  PlannedDrone drone(Start start) {
    return drones.get(start.drone() - 1);
  }

  MissionPad pad(Pad pad) {
    return pad(pad.id()).orElseThrow();
  }

  private Optional<MissionPad> pad(int id) {
    return arena.pads().stream().filter(pad -> pad.id() == id).findFirst();
  }

  /**
   * Returns a plan with an item moved. A hanging mission pad is moved to the nearest wall, and a
   * goal that names a gate or pad stays at that gate or pad.
   */
  FloorPlan with(PlanItem item, Placement placement) {
    return item.match(
        start -> with(start, drone(start).at(placement.pose())),
        pad -> with(pad, PadPlacement.moved(pad(pad), placement, arena.room())),
        obstacle ->
            with(obstacle, obstacle(obstacle).movedTo(placement.place(), placement.heading())),
        goal -> with(goal, GoalPlacement.moved(goal(goal), placement.place())));
  }

  /** Returns a plan with a drone replaced. */
  FloorPlan with(Start start, PlannedDrone drone) {
    return withDrones(edited(drones, all -> all.set(start.drone() - 1, drone)));
  }

  /** Returns a plan with a drone appended. */
  FloorPlan with(PlannedDrone drone) {
    return withDrones(edited(drones, all -> all.add(drone)));
  }

  /** Returns a plan with a mission pad replaced. */
  FloorPlan with(Pad item, MissionPad pad) {
    return withPads(edited(arena.pads(), all -> all.set(all.indexOf(pad(item)), pad)));
  }

  /** Returns a plan with a mission pad added. */
  FloorPlan with(MissionPad pad) {
    return withPads(edited(arena.pads(), all -> all.add(pad)));
  }

  /** Returns a plan with an obstacle replaced. */
  FloorPlan with(ObstacleItem item, Obstacle obstacle) {
    return withObstacles(edited(arena.obstacles(), all -> all.set(item.index(), obstacle)));
  }

  /** Returns a plan with an obstacle appended. */
  FloorPlan with(Obstacle obstacle) {
    return withObstacles(edited(arena.obstacles(), all -> all.add(obstacle)));
  }

  /** Returns a plan with a goal replaced. */
  FloorPlan with(GoalItem item, Goal goal) {
    return withGoals(edited(goals(), all -> all.set(item.index(), goal)));
  }

  /** Returns a plan with a goal appended. */
  FloorPlan with(Goal goal) {
    return withGoals(edited(goals(), all -> all.add(goal)));
  }

  /** Returns a plan with another challenge. */
  FloorPlan withChallenge(Challenge newChallenge) {
    return new FloorPlan(arena, drones, newChallenge);
  }

  /**
   * Returns a plan with a goal moved to another position in the order.
   *
   * @param number the new number, from 1
   */
  FloorPlan renumbered(GoalItem item, int number) {
    return withGoals(edited(goals(), all -> all.add(number - 1, all.remove(item.index()))));
  }

  /**
   * Returns a plan with a drone moved to another position in the order. Goals stay assigned to the
   * same drones.
   *
   * @param number the new number, from 1
   */
  FloorPlan renumbered(Start start, int number) {
    List<Integer> order =
        edited(
            IntStream.rangeClosed(1, drones.size()).boxed().toList(),
            all -> all.add(number - 1, all.remove(start.drone() - 1)));
    return withDrones(order.stream().map(old -> drones.get(old - 1)).toList())
        .withGoals(goals().stream().map(goal -> goal.forDrone(number(order, goal))).toList());
  }

  private static OptionalInt number(List<Integer> order, Goal goal) {
    return goal.drone().isPresent()
        ? OptionalInt.of(order.indexOf(goal.drone().getAsInt()) + 1)
        : goal.drone();
  }

  /** Returns a plan without the given items. */
  FloorPlan without(List<PlanItem> items) {
    List<PlanItem> present = items();
    FloorPlan rest = this;
    for (int i = present.size() - 1; i >= 0; i--) { // backwards, so that indices stay valid
      if (items.contains(present.get(i))) {
        rest = rest.without(present.get(i));
      }
    }
    return rest;
  }

  /** Returns a plan without an item; a drone may be removed only if no goal names it. */
  FloorPlan without(PlanItem item) {
    return item.match(
        start -> {
          FloorPlan last = renumbered(start, drones.size());
          return last.withDrones(last.drones.subList(0, drones.size() - 1));
        },
        pad -> withPads(edited(arena.pads(), all -> all.remove(pad(pad)))),
        obstacle -> withObstacles(edited(arena.obstacles(), all -> all.remove(obstacle.index()))),
        goal -> withGoals(edited(goals(), all -> all.remove(goal.index()))));
  }

  private static <T> List<T> edited(List<T> list, Consumer<List<T>> edit) {
    List<T> copy = new ArrayList<>(list);
    edit.accept(copy);
    return copy;
  }

  /** Returns the unused mission pad ids in ascending order. */
  List<Integer> freePadIds() {
    return IntStream.rangeClosed(1, MissionPad.LAST_ID)
        .boxed()
        .filter(id -> pad(id).isEmpty())
        .toList();
  }

  /** Returns the names of the obstacles. */
  Set<String> names() {
    return arena.obstacles().stream().map(Obstacle::name).collect(Collectors.toSet());
  }

  /** Returns an unused obstacle name such as {@code box 2}. */
  String freeName(String kind) {
    ObstacleNames names = new ObstacleNames();
    names().forEach(names::take);
    return names.next(kind);
  }

  /**
   * Returns a plan with the items of this plan in another room. That room keeps its own decor and
   * wind.
   */
  FloorPlan in(Arena present) {
    return withArena(present.withObstacles(arena.obstacles()).withPads(arena.pads()));
  }

  private FloorPlan withObstacles(List<Obstacle> obstacles) {
    return withArena(arena.withObstacles(obstacles));
  }

  private FloorPlan withPads(List<MissionPad> pads) {
    return withArena(arena.withPads(pads));
  }

  private FloorPlan withArena(Arena newArena) {
    return new FloorPlan(newArena, drones, challenge);
  }

  private FloorPlan withDrones(List<PlannedDrone> newDrones) {
    return new FloorPlan(arena, newDrones, challenge);
  }

  private FloorPlan withGoals(List<Goal> goals) {
    return withChallenge(challenge.withGoals(goals));
  }
}
