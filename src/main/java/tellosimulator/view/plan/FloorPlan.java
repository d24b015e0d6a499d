package tellosimulator.view.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import tellosimulator.goal.Goal;
import tellosimulator.math.Pose;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
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
 * @param starts of the drones, in the order of their numbers
 */
record FloorPlan(Arena arena, List<Pose> starts) {

  FloorPlan {
    starts = List.copyOf(starts);
  }

  /** That of a simulation. */
  static FloorPlan of(SimSnapshot snapshot) {
    return new FloorPlan(
        snapshot.arena(), snapshot.drones().stream().map(DroneSnapshot::start).toList());
  }

  /** Everything, in the order of drawing: later ones lie over earlier ones. */
  List<PlanItem> items() {
    Stream<PlanItem> pads = arena.pads().stream().map(pad -> new Pad(pad.id()));
    Stream<PlanItem> things =
        IntStream.range(0, arena.obstacles().size()).mapToObj(ObstacleItem::new);
    Stream<PlanItem> drones = IntStream.rangeClosed(1, starts.size()).mapToObj(Start::new);
    return Stream.of(pads, things, drones).flatMap(all -> all).toList();
  }

  /** Whether there is such an item. */
  boolean has(PlanItem item) {
    if (item instanceof ObstacleItem body) {
      return body.index() < arena.obstacles().size();
    } else if (item instanceof Pad pad) {
      return pad(pad.id()).isPresent();
    }
    return ((Start) item).drone() <= starts.size();
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
    }
    return Placement.of(starts.get(((Start) item).drone() - 1));
  }

  /** What an item covers of the floor. */
  PlanOutline outline(PlanItem item) {
    if (item instanceof ObstacleItem body) {
      return PlanOutline.of(obstacle(body).shape());
    } else if (item instanceof Pad known) {
      return PlanOutline.of(pad(known));
    }
    return PlanOutline.ofDrone();
  }

  Obstacle obstacle(ObstacleItem item) {
    return arena.obstacles().get(item.index());
  }

  MissionPad pad(Pad pad) {
    return pad(pad.id()).orElseThrow();
  }

  private Optional<MissionPad> pad(int id) {
    return arena.pads().stream().filter(pad -> pad.id() == id).findFirst();
  }

  /** The same with an item elsewhere; a hanging mission pad stays at the wall that is nearest. */
  FloorPlan with(PlanItem item, Placement placement) {
    if (item instanceof ObstacleItem body) {
      List<Obstacle> obstacles = new ArrayList<>(arena.obstacles());
      obstacles.set(body.index(), obstacle(body).movedTo(placement.place(), placement.heading()));
      return withArena(arena.withObstacles(obstacles));
    } else if (item instanceof Pad known) {
      return replacing(known.id(), PadPlacement.moved(pad(known), placement, arena.room()));
    }
    List<Pose> newStarts = new ArrayList<>(starts);
    newStarts.set(((Start) item).drone() - 1, placement.pose());
    return new FloorPlan(arena, newStarts);
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

  /** The same without an item; starts stay. */
  FloorPlan without(PlanItem item) {
    if (item instanceof ObstacleItem body) {
      List<Obstacle> obstacles = new ArrayList<>(arena.obstacles());
      obstacles.remove(body.index());
      return withArena(arena.withObstacles(obstacles));
    } else if (item instanceof Pad known) {
      return withArena(
          arena.withPads(arena.pads().stream().filter(pad -> pad.id() != known.id()).toList()));
    }
    return this;
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
    return new FloorPlan(newArena, starts);
  }
}
