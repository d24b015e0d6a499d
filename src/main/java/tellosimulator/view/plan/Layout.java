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
import tellosimulator.view.plan.Piece.Pad;
import tellosimulator.view.plan.Piece.Start;
import tellosimulator.view.plan.Piece.Thing;
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
record Layout(Arena arena, List<Pose> starts) {

  Layout {
    starts = List.copyOf(starts);
  }

  /** That of a simulation. */
  static Layout of(SimSnapshot snapshot) {
    return new Layout(
        snapshot.arena(), snapshot.drones().stream().map(DroneSnapshot::start).toList());
  }

  /** Everything, in the order of drawing: later ones lie over earlier ones. */
  List<Piece> pieces() {
    Stream<Piece> pads = arena.pads().stream().map(pad -> new Pad(pad.id()));
    Stream<Piece> things = IntStream.range(0, arena.obstacles().size()).mapToObj(Thing::new);
    Stream<Piece> drones = IntStream.rangeClosed(1, starts.size()).mapToObj(Start::new);
    return Stream.of(pads, things, drones).flatMap(all -> all).toList();
  }

  /** Whether there is such a piece. */
  boolean has(Piece piece) {
    if (piece instanceof Thing thing) {
      return thing.index() < arena.obstacles().size();
    } else if (piece instanceof Pad pad) {
      return pad(pad.id()).isPresent();
    }
    return ((Start) piece).drone() <= starts.size();
  }

  /** Whether what a goal names is there. */
  boolean offers(Goal goal) {
    if (goal instanceof Goal.Pass pass) {
      return arena.obstacles().stream().anyMatch(obstacle -> obstacle.name().equals(pass.gate()));
    }
    return !(goal instanceof Goal.LandOn land) || pad(land.pad()).isPresent();
  }

  /** Where a piece is; of a hanging mission pad, its heading is out of the wall. */
  Spot spot(Piece piece) {
    if (piece instanceof Thing thing) {
      Obstacle obstacle = obstacle(thing);
      return new Spot(obstacle.foot(), obstacle.heading());
    } else if (piece instanceof Pad known) {
      return Walls.spot(pad(known), arena.room());
    }
    return Spot.of(starts.get(((Start) piece).drone() - 1));
  }

  /** What a piece covers of the floor. */
  Outline outline(Piece piece) {
    if (piece instanceof Thing thing) {
      return Outline.of(obstacle(thing).shape());
    } else if (piece instanceof Pad known) {
      return Outline.of(pad(known));
    }
    return Outline.ofDrone();
  }

  Obstacle obstacle(Thing thing) {
    return arena.obstacles().get(thing.index());
  }

  MissionPad pad(Pad pad) {
    return pad(pad.id()).orElseThrow();
  }

  private Optional<MissionPad> pad(int id) {
    return arena.pads().stream().filter(pad -> pad.id() == id).findFirst();
  }

  /** The same with a piece elsewhere; a hanging mission pad stays at the wall that is nearest. */
  Layout with(Piece piece, Spot spot) {
    if (piece instanceof Thing thing) {
      List<Obstacle> obstacles = new ArrayList<>(arena.obstacles());
      obstacles.set(thing.index(), obstacle(thing).movedTo(spot.place(), spot.heading()));
      return withArena(arena.withObstacles(obstacles));
    } else if (piece instanceof Pad known) {
      MissionPad moved = Walls.moved(pad(known), spot, arena.room());
      return withArena(
          arena.withPads(
              arena.pads().stream().map(pad -> pad.id() == moved.id() ? moved : pad).toList()));
    }
    List<Pose> newStarts = new ArrayList<>(starts);
    newStarts.set(((Start) piece).drone() - 1, spot.pose());
    return new Layout(arena, newStarts);
  }

  /** The same with another obstacle, as the last one. */
  Layout with(Obstacle obstacle) {
    List<Obstacle> obstacles = new ArrayList<>(arena.obstacles());
    obstacles.add(obstacle);
    return withArena(arena.withObstacles(obstacles));
  }

  /** The same with another obstacle in the place of one. */
  Layout with(Thing thing, Obstacle obstacle) {
    List<Obstacle> obstacles = new ArrayList<>(arena.obstacles());
    obstacles.set(thing.index(), obstacle);
    return withArena(arena.withObstacles(obstacles));
  }

  /** The same with another mission pad. */
  Layout with(MissionPad pad) {
    List<MissionPad> pads = new ArrayList<>(arena.pads());
    pads.add(pad);
    return withArena(arena.withPads(pads));
  }

  /** The same without a piece; starts stay. */
  Layout without(Piece piece) {
    if (piece instanceof Thing thing) {
      List<Obstacle> obstacles = new ArrayList<>(arena.obstacles());
      obstacles.remove(thing.index());
      return withArena(arena.withObstacles(obstacles));
    } else if (piece instanceof Pad known) {
      return withArena(
          arena.withPads(arena.pads().stream().filter(pad -> pad.id() != known.id()).toList()));
    }
    return this;
  }

  /** The lowest id that no mission pad has. */
  Optional<Integer> freePadId() {
    return IntStream.rangeClosed(1, MissionPad.LAST_ID)
        .boxed()
        .filter(id -> pad(id).isEmpty())
        .findFirst();
  }

  /** A name that no obstacle has: {@code box 2}. */
  String freeName(String kind) {
    ObstacleNames names = new ObstacleNames();
    arena.obstacles().forEach(obstacle -> names.take(obstacle.name()));
    return names.next(kind);
  }

  /** These pieces in a room that may have become another one, with its own looks and wind. */
  Layout in(Arena present) {
    return withArena(present.withObstacles(arena.obstacles()).withPads(arena.pads()));
  }

  private Layout withArena(Arena newArena) {
    return new Layout(newArena, starts);
  }
}
