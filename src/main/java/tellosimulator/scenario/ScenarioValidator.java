package tellosimulator.scenario;

import java.net.InetAddress;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.scenario.Diagnostic.Place;
import tellosimulator.scenario.ListCodec.Item;
import tellosimulator.scenario.Scenario.CommandAddress;
import tellosimulator.words.Phrase;
import tellosimulator.words.Printable;
import tellosimulator.words.Spelling;
import tellosimulator.world.Arena;
import tellosimulator.world.Collider;
import tellosimulator.world.Decor;
import tellosimulator.world.Footprint;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Obstacles;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;
import tellosimulator.world.Surface;

/** Checks whether the parts of a scenario are consistent after they have been read. */
final class ScenarioValidator {

  /**
   * Factor by which a radius is multiplied, so that a point at the resulting distance is inside
   * despite rounding.
   */
  private static final double INSIDE = 0.999;

  /**
   * Distance before and behind the opening of a gate at which a drone must fit [m]. Decided: there
   * it has left the gate.
   */
  private static final double GATE_LEAD = 0.3;

  /** The space in which nothing may stand on a mission pad. */
  private static final Collider CARD = new Collider(MissionPad.EDGE / 2, 0.01);

  /** Unit vectors towards the faces, edges and corners of a cube. */
  private static final List<Vec3> BALL = directions(-1, 1);

  /** Horizontal unit vectors, 45 degrees apart. */
  private static final List<Vec3> DISC = directions(0, 0);

  private final Room room;
  private final Diagnostics diagnostics;

  ScenarioValidator(Room room, Diagnostics diagnostics) {
    this.room = room;
    this.diagnostics = diagnostics;
  }

  private static List<Vec3> directions(int lowest, int highest) {
    List<Vec3> directions = new ArrayList<>();
    for (int x = -1; x <= 1; x++) {
      for (int y = -1; y <= 1; y++) {
        for (int z = lowest; z <= highest; z++) {
          Vec3 direction = new Vec3(x, y, z);
          if (direction.norm() > 0) {
            directions.add(direction.times(1 / direction.norm()));
          }
        }
      }
    }
    return directions;
  }

  /** Checks that the names of the obstacles are unique. */
  void names(List<Item<ObstacleCodecs.ParsedObstacle>> obstacles) {
    Set<String> names = new HashSet<>();
    for (Item<ObstacleCodecs.ParsedObstacle> obstacle : obstacles) {
      String name = obstacle.value().obstacle().name();
      if (!name.isEmpty() && !names.add(name)) {
        diagnostics.add(
            obstacle.place(), Phrase.of("there are two obstacles of the name %s", name));
      }
    }
  }

  void obstacles(List<Item<Obstacle>> obstacles) {
    for (Item<Obstacle> obstacle : obstacles) {
      if (!Footprint.inside(obstacle.value(), room)) {
        diagnostics.misfit(
            obstacle.place(),
            Phrase.of("the obstacle \"%s\" is not in the room", obstacle.value().name()));
      }
    }
  }

  void posters(List<Item<Poster>> posters) {
    for (Item<Poster> poster : posters) {
      if (!Footprint.inside(poster.value(), room)) {
        diagnostics.misfit(
            poster.place(),
            Phrase.of("the middle of the poster is not on %s", poster.value().surface().phrase()));
      }
    }
  }

  void pads(List<Item<MissionPad>> pads) {
    Set<Integer> ids = new HashSet<>();
    for (Item<MissionPad> pad : pads) {
      int id = pad.value().id();
      if (!ids.add(id)) {
        diagnostics.add(pad.place(), Phrase.of("there are two mission pads of the number %d", id));
      }
      if (!Footprint.inside(pad.value(), room)) {
        diagnostics.misfit(
            pad.place(),
            Phrase.of("the mission pad %d is not on %s", id, pad.value().surface().phrase()));
      }
    }
  }

  /**
   * Checks that the drones at their starts fit into the room, and overlap neither obstacles nor
   * each other.
   */
  void starts(List<Item<DroneCodec.DronePlacement>> drones, List<Obstacle> obstacles) {
    Obstacles around = around(obstacles);
    for (int i = 0; i < drones.size(); i++) {
      Item<DroneCodec.DronePlacement> drone = drones.get(i);
      Vec3 start = start(drone);
      if (!room.contains(start, DroneSpec.COLLIDER)) {
        diagnostics.misfit(
            drone.place(), Phrase.of("drone %d does not fit into the room there", drone.number()));
      }
      Optional<Obstacle> obstacle = around.around(start, DroneSpec.COLLIDER);
      if (obstacle.isPresent()) {
        diagnostics.misfit(
            drone.place(), Phrase.of("drone %d is in %s", drone.number(), obstacle.get().phrase()));
      }
      for (Item<DroneCodec.DronePlacement> other : drones.subList(0, i)) {
        if (start.distanceTo(start(other)) < 2 * DroneSpec.COLLIDER.radius()) {
          diagnostics.misfit(
              drone.place(), Phrase.of("drone %d is in drone %d", drone.number(), other.number()));
        }
      }
    }
  }

  private static Vec3 start(Item<DroneCodec.DronePlacement> drone) {
    return drone.value().setup().start().position();
  }

  /**
   * Checks that all drones have different command addresses. The default address of drone n is
   * 127.0.0.n.
   */
  void addresses(List<Item<DroneCodec.DronePlacement>> drones) {
    Map<String, Integer> taken = new HashMap<>();
    for (Item<DroneCodec.DronePlacement> drone : drones) {
      CommandAddress station = drone.value().station();
      String host =
          station.address().map(InetAddress::getHostAddress).orElse("127.0.0." + drone.number());
      Integer other = taken.putIfAbsent(host + ":" + station.port().orElse(0), drone.number());
      if (other != null) {
        diagnostics.add(
            drone.place(),
            Phrase.of("drone %d takes commands where drone %d does", drone.number(), other));
      }
    }
  }

  /** Checks that the places of goals are in the room. */
  void places(List<Item<Goal>> goals) {
    for (Item<Goal> goal : goals) {
      if (goal.value() instanceof Goal.InRegion place
          && !Footprint.inside(place.region().place(), room)) {
        diagnostics.misfit(goal.place(), Phrase.of("this place is not in the room"));
      }
    }
  }

  /**
   * Checks that obstacles do not fill the whole region of a goal. Only the middle of the region and
   * some points on its boundary are tested.
   */
  void reachable(List<Item<Goal>> goals, List<MissionPad> pads, List<Obstacle> obstacles) {
    Obstacles around = around(obstacles);
    for (Item<Goal> goal : goals) {
      if (goal.value() instanceof Goal.Reach || goal.value() instanceof Goal.Hover) {
        GoalRegion region = ((Goal.InRegion) goal.value()).region();
        reachable(goal, region.place(), around, INSIDE * region.radius(), BALL);
      } else if (goal.value() instanceof Goal.LandOn land) {
        pads.stream()
            .filter(pad -> pad.id() == land.pad() && pad.surface() == Surface.FLOOR)
            .forEach(
                pad ->
                    reachable(goal, pad.pose(room).position(), around, MissionPad.EDGE / 2, DISC));
      }
    }
  }

  private void reachable(
      Item<Goal> goal, Vec3 place, Obstacles around, double radius, List<Vec3> directions) {
    Optional<Obstacle> obstacle = around.around(place, DroneSpec.COLLIDER);
    boolean free =
        directions.stream()
            .map(direction -> place.plusScaled(direction, radius))
            .filter(each -> room.contains(each, DroneSpec.COLLIDER))
            .anyMatch(each -> around.around(each, DroneSpec.COLLIDER).isEmpty());
    if (obstacle.isPresent() && !free) {
      diagnostics.misfit(
          goal.place(),
          Phrase.of("no drone can reach this place: it is in %s", obstacle.get().phrase()));
    }
  }

  /** Checks that drawn obstacles do not overlap others. Walls may cross walls. */
  void overlaps(List<Item<ObstacleCodecs.ParsedObstacle>> written, List<Item<Obstacle>> obstacles) {
    Obstacles around = around(Item.values(obstacles));
    Set<Obstacle> walls = new HashSet<>();
    for (int i = 0; i < written.size(); i++) {
      if (written.get(i).value().notation().kind() == SourceForm.Kind.WALL) {
        walls.add(obstacles.get(i).value());
      }
    }
    for (Item<Obstacle> drawn : obstacles) {
      boolean wall = walls.contains(drawn.value());
      Optional<Obstacle> other =
          drawn.drawn()
              ? around.overlapping(drawn.value(), each -> !(wall && walls.contains(each)))
              : Optional.empty();
      other.ifPresent(
          each ->
              diagnostics.misfit(
                  drawn.place(),
                  Phrase.of("%s and %s overlap", drawn.value().phrase(), each.phrase())));
    }
  }

  /** Checks that mission pads lie neither on each other nor under obstacles. */
  void covered(List<Item<MissionPad>> pads, List<Obstacle> obstacles) {
    Obstacles around = around(obstacles);
    for (Item<MissionPad> drawn : pads) {
      if (drawn.value().surface() == Surface.FLOOR) {
        around
            .around(drawn.value().pose(room).position(), CARD)
            .ifPresent(
                obstacle ->
                    diagnostics.misfit(
                        drawn.place(),
                        Phrase.of(
                            "mission pad %d is under %s", drawn.value().id(), obstacle.phrase())));
      }
      for (Item<MissionPad> other : pads) {
        Vec3 place = drawn.value().pose(room).position();
        if (other.number() < drawn.number()
            && place.distanceTo(other.value().pose(room).position()) < MissionPad.EDGE) {
          diagnostics.misfit(
              drawn.place(),
              Phrase.of(
                  "mission pad %d is on mission pad %d", drawn.value().id(), other.value().id()));
        }
      }
    }
  }

  /** Checks that a drone can fly through the gates named by goals. */
  void passable(List<Item<Goal>> goals, List<Obstacle> obstacles) {
    Obstacles around = around(obstacles);
    for (Item<Goal> goal : goals) {
      if (goal.value() instanceof Goal.Pass pass) {
        obstacles.stream()
            .filter(obstacle -> obstacle.name().equals(pass.gate()))
            .filter(obstacle -> obstacle.shape() instanceof Shape.Gate)
            .forEach(gate -> passable(goal, gate, around));
      }
    }
  }

  private void passable(Item<Goal> goal, Obstacle gate, Obstacles around) {
    Vec3 along = gate.pose().attitude().toRoom(new Vec3(1, 0, 0));
    double middle = ((Shape.Gate) gate.shape()).middle() - DroneSpec.COLLIDER.height() / 2;
    for (int way = -1; way <= 1; way++) {
      Vec3 place = gate.foot().plusScaled(Vec3.UP, middle).plusScaled(along, way * GATE_LEAD);
      Optional<Phrase> hindrance =
          room.contains(place, DroneSpec.COLLIDER)
              ? around.around(place, DroneSpec.COLLIDER).map(Obstacle::phrase)
              : Optional.of(Phrase.of("a wall of the room"));
      if (hindrance.isPresent()) {
        diagnostics.misfit(
            goal.place(),
            Phrase.of("no drone can fly through this gate: %s is in the way", hindrance.get()));
        return;
      }
    }
  }

  private Obstacles around(List<Obstacle> obstacles) {
    return Obstacles.of(Arena.empty(room, Decor.DEFAULT).withObstacles(obstacles));
  }

  /** Checks that the gates named by goals exist. */
  void gates(List<Item<Goal>> goals, List<Obstacle> obstacles) {
    for (Item<Goal> goal : goals) {
      if (goal.value() instanceof Goal.Pass pass) {
        gate(goal.place(), pass.gate(), obstacles);
      }
    }
  }

  private void gate(Place place, String name, List<Obstacle> obstacles) {
    Optional<Obstacle> named =
        obstacles.stream().filter(obstacle -> obstacle.name().equals(name)).findFirst();
    if (named.isPresent()) {
      if (!(named.get().shape() instanceof Shape.Gate)) {
        diagnostics.add(place, Phrase.of("the obstacle \"%s\" is no gate", name));
      }
      return;
    }
    Set<String> gates =
        obstacles.stream()
            .filter(obstacle -> obstacle.shape() instanceof Shape.Gate)
            .map(Obstacle::name)
            .collect(Collectors.toSet());
    String shown = Printable.quoted(name);
    diagnostics.add(
        place,
        Spelling.meant(name, gates)
            .map(meant -> Phrase.of("there is no gate %s, did you mean %s?", shown, meant))
            .orElseGet(() -> Phrase.of("there is no gate %s", shown)));
  }

  /** Checks that the mission pads named by goals lie on the floor. */
  void padsToLandOn(List<Item<Goal>> goals, List<MissionPad> pads) {
    for (Item<Goal> goal : goals) {
      if (goal.value() instanceof Goal.LandOn land && !lies(land.pad(), pads)) {
        diagnostics.add(goal.place(), Phrase.of("no mission pad %d lies on the floor", land.pad()));
      }
    }
  }

  private static boolean lies(int id, List<MissionPad> pads) {
    return pads.stream().anyMatch(pad -> pad.id() == id && pad.surface() == Surface.FLOOR);
  }

  /** Checks that there are the mission pads to be seen. */
  void padsToSee(List<Item<Goal>> goals, List<MissionPad> pads) {
    for (Item<Goal> goal : goals) {
      if (goal.value() instanceof Goal.See see
          && see.target() instanceof Goal.NumberedPad target
          && pads.stream().noneMatch(pad -> pad.id() == target.pad())) {
        diagnostics.add(goal.place(), Phrase.of("there is no mission pad %d", target.pad()));
      }
    }
  }

  /** Checks that there is one poster of each name that is to be seen. */
  void postersToSee(List<Item<Goal>> goals, List<Poster> posters) {
    List<String> names = posters.stream().map(Poster::name).toList();
    for (Item<Goal> goal : goals) {
      if (goal.value() instanceof Goal.See see && see.target() instanceof Goal.NamedPoster target) {
        int count = Collections.frequency(names, target.name());
        if (count == 0) {
          diagnostics.add(goal.place(), noPoster(target.name(), Set.copyOf(names)));
        } else if (count > 1) {
          diagnostics.add(
              goal.place(),
              Phrase.of(
                  "there are %d posters of the name %s: name one of them", count, target.name()));
        }
      }
    }
  }

  private static Phrase noPoster(String name, Set<String> posters) {
    String shown = Printable.quoted(name);
    return Spelling.meant(name, posters)
        .map(meant -> Phrase.of("there is no poster %s, did you mean %s?", shown, meant))
        .orElseGet(() -> Phrase.of("there is no poster %s", shown));
  }
}
