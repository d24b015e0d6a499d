package tellosimulator.scenario;

import java.net.InetAddress;
import java.util.ArrayList;
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
import tellosimulator.scenario.Scenario.Station;
import tellosimulator.words.Phrase;
import tellosimulator.words.Spelling;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;
import tellosimulator.world.Footprint;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Obstacles;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;
import tellosimulator.world.Surface;

/** Looks whether what was read fits together. */
final class ScenarioValidator {

  /** Part of a radius that is within it whatever the rounding. */
  private static final double INSIDE = 0.999;

  /** Unit vectors to all sides, 45 degrees apart. */
  private static final List<Vec3> BALL = directions(-1, 1);

  /** The same on the level. */
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

  /** Whether the names are different. */
  void names(List<Item<ObstacleCodecs.NotedObstacle>> obstacles) {
    Set<String> names = new HashSet<>();
    for (Item<ObstacleCodecs.NotedObstacle> obstacle : obstacles) {
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
        diagnostics.add(
            obstacle.place(),
            Phrase.of("the obstacle \"%s\" is not in the room", obstacle.value().name()));
      }
    }
  }

  void posters(List<Item<Poster>> posters) {
    for (Item<Poster> poster : posters) {
      if (!Footprint.inside(poster.value(), room)) {
        diagnostics.add(
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
        diagnostics.add(
            pad.place(),
            Phrase.of("the mission pad %d is not on %s", id, pad.value().surface().phrase()));
      }
    }
  }

  /** Where the drones stand. */
  void starts(List<Item<DroneCodec.StationedDrone>> drones, List<Obstacle> obstacles) {
    Obstacles around = Obstacles.of(Arena.empty(room, Decor.DEFAULT).withObstacles(obstacles));
    for (int i = 0; i < drones.size(); i++) {
      Item<DroneCodec.StationedDrone> drone = drones.get(i);
      Vec3 start = start(drone);
      if (!room.contains(start, DroneSpec.COLLIDER)) {
        diagnostics.add(
            drone.place(), Phrase.of("drone %d does not fit into the room there", drone.number()));
      }
      Optional<Obstacle> obstacle = around.around(start, DroneSpec.COLLIDER);
      if (obstacle.isPresent()) {
        diagnostics.add(
            drone.place(), Phrase.of("drone %d is in %s", drone.number(), obstacle.get().phrase()));
      }
      for (Item<DroneCodec.StationedDrone> other : drones.subList(0, i)) {
        if (start.distanceTo(start(other)) < 2 * DroneSpec.COLLIDER.radius()) {
          diagnostics.add(
              drone.place(), Phrase.of("drone %d is in drone %d", drone.number(), other.number()));
        }
      }
    }
  }

  private static Vec3 start(Item<DroneCodec.StationedDrone> drone) {
    return drone.value().setup().start().position();
  }

  /** Where the drones take commands; drone 1 is taken to be at 127.0.0.1 if nothing is said. */
  void addresses(List<Item<DroneCodec.StationedDrone>> drones) {
    Map<String, Integer> taken = new HashMap<>();
    for (Item<DroneCodec.StationedDrone> drone : drones) {
      Station station = drone.value().station();
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

  /** The places of goals. */
  void places(List<Item<Goal>> goals) {
    for (Item<Goal> goal : goals) {
      if (goal.value() instanceof Goal.InRegion place
          && !Footprint.inside(place.region().place(), room)) {
        diagnostics.add(goal.place(), Phrase.of("this place is not in the room"));
      }
    }
  }

  /** Whether a drone can be where goals want it: obstacles may fill all of a place. */
  void reachable(List<Item<Goal>> goals, List<MissionPad> pads, List<Obstacle> obstacles) {
    Obstacles around = Obstacles.of(Arena.empty(room, Decor.DEFAULT).withObstacles(obstacles));
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
      diagnostics.add(
          goal.place(),
          Phrase.of("no drone can reach this place: it is in %s", obstacle.get().phrase()));
    }
  }

  /** The gates that goals name. */
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
    String shown = Diagnostics.shown(name);
    diagnostics.add(
        place,
        Spelling.meant(name, gates)
            .map(meant -> Phrase.of("there is no gate %s, did you mean %s?", shown, meant))
            .orElseGet(() -> Phrase.of("there is no gate %s", shown)));
  }

  /** The mission pads that goals name. */
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
}
