package tellosimulator.view.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
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
 * Everything that can be placed in a room, and where it is. Immutable.
 *
 * @param arena the room with obstacles and mission pads
 * @param drones in the order of their numbers
 * @param challenge what they shall do
 */
record FloorPlan(Arena arena, List<PlannedDrone> drones, Challenge challenge) {

  FloorPlan {
    drones = List.copyOf(drones);
  }

  /**
   * That of a simulation.
   *
   * @param origins of its drones, in the order of their numbers
   */
  static FloorPlan of(SimSnapshot snapshot, List<DroneOrigin> origins, Challenge challenge) {
    List<PlannedDrone> drones = new ArrayList<>();
    for (DroneSnapshot drone : snapshot.drones()) {
      drones.add(new PlannedDrone(origins.get(drones.size()), drone.start()));
    }
    return new FloorPlan(snapshot.arena(), drones, challenge);
  }

  /** Where the drones start, in the order of their numbers. */
  List<Pose> starts() {
    return drones.stream().map(PlannedDrone::start).toList();
  }

  /** Where the drones come from, in the order of their numbers. */
  List<DroneOrigin> origins() {
    return drones.stream().map(PlannedDrone::origin).toList();
  }

  List<Goal> goals() {
    return challenge.goals();
  }

  /** Everything, in the order of drawing: later ones lie over earlier ones. */
  List<PlanItem> items() {
    Stream<PlanItem> pads = arena.pads().stream().map(pad -> new Pad(pad.id()));
    Stream<PlanItem> things =
        IntStream.range(0, arena.obstacles().size()).mapToObj(ObstacleItem::new);
    Stream<PlanItem> all = IntStream.rangeClosed(1, drones.size()).mapToObj(Start::new);
    Stream<PlanItem> asked = IntStream.range(0, goals().size()).mapToObj(GoalItem::new);
    return Stream.of(asked, pads, things, all).flatMap(items -> items).toList();
  }

  /** Whether there is such an item. */
  boolean has(PlanItem item) {
    if (item instanceof ObstacleItem body) {
      return body.index() < arena.obstacles().size();
    } else if (item instanceof Pad pad) {
      return pad(pad.id()).isPresent();
    } else if (item instanceof GoalItem goal) {
      return goal.index() < goals().size();
    }
    return ((Start) item).drone() <= drones.size();
  }

  /** Whether what a goal names is there. */
  boolean offers(Goal goal) {
    if (goal instanceof Goal.Pass pass) {
      return arena.obstacles().stream().anyMatch(obstacle -> obstacle.name().equals(pass.gate()));
    }
    return !(goal instanceof Goal.LandOn land) || pad(land.pad()).isPresent();
  }

  /** Where an item is; of a hanging mission pad, its heading is out of the wall. */
  Placement placement(PlanItem item) {
    if (item instanceof ObstacleItem body) {
      Obstacle obstacle = obstacle(body);
      return new Placement(obstacle.foot(), obstacle.heading());
    } else if (item instanceof Pad known) {
      return PadPlacement.placement(pad(known), arena.room());
    } else if (item instanceof GoalItem goal) {
      return GoalPlacement.placement(goal(goal), this);
    }
    return Placement.of(drone((Start) item).start());
  }

  /** What an item covers of the floor. */
  PlanOutline outline(PlanItem item) {
    if (item instanceof ObstacleItem body) {
      return PlanOutline.of(obstacle(body).shape());
    } else if (item instanceof Pad known) {
      return PlanOutline.of(pad(known));
    } else if (item instanceof GoalItem goal) {
      return GoalPlacement.outline(goal(goal), this);
    }
    return PlanOutline.ofDrone();
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
   * The same with an item elsewhere; a hanging mission pad stays at the wall that is nearest, and a
   * goal at the gate or pad that it names.
   */
  FloorPlan with(PlanItem item, Placement placement) {
    if (item instanceof ObstacleItem body) {
      List<Obstacle> obstacles = new ArrayList<>(arena.obstacles());
      obstacles.set(body.index(), obstacle(body).movedTo(placement.place(), placement.heading()));
      return withArena(arena.withObstacles(obstacles));
    } else if (item instanceof Pad known) {
      return replacing(known.id(), PadPlacement.moved(pad(known), placement, arena.room()));
    }
    if (item instanceof GoalItem goal) {
      return with(goal, GoalPlacement.moved(goal(goal), placement.place()));
    }
    return with((Start) item, drone((Start) item).at(placement.pose()));
  }

  /** The same with another drone in the place of one. */
  FloorPlan with(Start start, PlannedDrone drone) {
    List<PlannedDrone> others = new ArrayList<>(drones);
    others.set(start.drone() - 1, drone);
    return new FloorPlan(arena, others, challenge);
  }

  /** The same with another drone, as the last one. */
  FloorPlan with(PlannedDrone drone) {
    List<PlannedDrone> all = new ArrayList<>(drones);
    all.add(drone);
    return new FloorPlan(arena, all, challenge);
  }

  /** The same with another goal in the place of one. */
  FloorPlan with(GoalItem item, Goal goal) {
    List<Goal> others = new ArrayList<>(goals());
    others.set(item.index(), goal);
    return withChallenge(others);
  }

  /** The same with another goal, as the last one. */
  FloorPlan with(Goal goal) {
    List<Goal> all = new ArrayList<>(goals());
    all.add(goal);
    return withChallenge(all);
  }

  private FloorPlan withChallenge(List<Goal> goals) {
    return withChallenge(challenge.withGoals(goals));
  }

  /** The same for drones that shall do something else. */
  FloorPlan withChallenge(Challenge newChallenge) {
    return new FloorPlan(arena, drones, newChallenge);
  }

  /**
   * The same with a goal at another place in their order.
   *
   * @param number from 1
   */
  FloorPlan renumbered(GoalItem item, int number) {
    List<Goal> others = new ArrayList<>(goals());
    others.add(number - 1, others.remove(item.index()));
    return withChallenge(others);
  }

  /**
   * The same with a drone at another place in their order; the goals of each stay its own.
   *
   * @param number from 1
   */
  FloorPlan renumbered(Start start, int number) {
    List<Integer> order = new ArrayList<>(IntStream.rangeClosed(1, drones.size()).boxed().toList());
    order.add(number - 1, order.remove(start.drone() - 1));
    List<PlannedDrone> others = order.stream().map(old -> drones.get(old - 1)).toList();
    return new FloorPlan(arena, others, challenge)
        .withChallenge(goals().stream().map(goal -> goal.forDrone(number(order, goal))).toList());
  }

  private static OptionalInt number(List<Integer> order, Goal goal) {
    return goal.drone().isPresent()
        ? OptionalInt.of(order.indexOf(goal.drone().getAsInt()) + 1)
        : goal.drone();
  }

  /** The same with another obstacle, as the last one. */
  FloorPlan with(Obstacle obstacle) {
    List<Obstacle> obstacles = new ArrayList<>(arena.obstacles());
    obstacles.add(obstacle);
    return withArena(arena.withObstacles(obstacles));
  }

  /** The same with another obstacle in the place of one. */
  FloorPlan with(ObstacleItem item, Obstacle obstacle) {
    List<Obstacle> obstacles = new ArrayList<>(arena.obstacles());
    obstacles.set(item.index(), obstacle);
    return withArena(arena.withObstacles(obstacles));
  }

  /** The same with another mission pad in the place of that of an id. */
  FloorPlan replacing(int id, MissionPad other) {
    return withArena(
        arena.withPads(arena.pads().stream().map(pad -> pad.id() == id ? other : pad).toList()));
  }

  /** The same with another mission pad. */
  FloorPlan with(MissionPad pad) {
    List<MissionPad> pads = new ArrayList<>(arena.pads());
    pads.add(pad);
    return withArena(arena.withPads(pads));
  }

  /** The same without some items. */
  FloorPlan without(List<PlanItem> items) {
    List<PlanItem> present = items();
    FloorPlan rest = this;
    for (int i = present.size() - 1; i >= 0; i--) { // so that the numbers of those before stay
      if (items.contains(present.get(i))) {
        rest = rest.without(present.get(i));
      }
    }
    return rest;
  }

  /** The same without an item; a drone that goes is one that no goal names. */
  FloorPlan without(PlanItem item) {
    if (item instanceof ObstacleItem body) {
      List<Obstacle> obstacles = new ArrayList<>(arena.obstacles());
      obstacles.remove(body.index());
      return withArena(arena.withObstacles(obstacles));
    } else if (item instanceof Pad known) {
      return withArena(
          arena.withPads(arena.pads().stream().filter(pad -> pad.id() != known.id()).toList()));
    } else if (item instanceof GoalItem goal) {
      List<Goal> others = new ArrayList<>(goals());
      others.remove(goal.index());
      return withChallenge(others);
    }
    FloorPlan last = renumbered((Start) item, drones.size());
    return new FloorPlan(arena, last.drones.subList(0, drones.size() - 1), last.challenge);
  }

  /** The ids that no mission pad has, the lowest one first. */
  List<Integer> freePadIds() {
    return IntStream.rangeClosed(1, MissionPad.LAST_ID)
        .boxed()
        .filter(id -> pad(id).isEmpty())
        .toList();
  }

  /** A name that no obstacle has: {@code box 2}. */
  String freeName(String kind) {
    ObstacleNames names = new ObstacleNames();
    arena.obstacles().forEach(obstacle -> names.take(obstacle.name()));
    return names.next(kind);
  }

  /** These items in a room that may have become another one, with its own looks and wind. */
  FloorPlan in(Arena present) {
    return withArena(present.withObstacles(arena.obstacles()).withPads(arena.pads()));
  }

  private FloorPlan withArena(Arena newArena) {
    return new FloorPlan(newArena, drones, challenge);
  }
}
