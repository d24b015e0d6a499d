package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.snakeyaml.engine.v2.nodes.Node;
import tellosimulator.goal.Goal;
import tellosimulator.goal.Spot;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.scenario.Scenario.Station;
import tellosimulator.scenario.Section.Located;
import tellosimulator.words.Phrase;
import tellosimulator.words.Spelling;
import tellosimulator.world.Arena;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Obstacles;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;
import tellosimulator.world.Surface;

/** Looks whether what was read fits together. */
final class Checks {

  private final Room room;
  private final Mistakes mistakes;

  /** Of which things all could be read. */
  record Whole(boolean obstacles, boolean pads) {}

  Checks(Room room, Mistakes mistakes) {
    this.room = room;
    this.mistakes = mistakes;
  }

  /** Gives names to those that have none, and looks whether the names are different. */
  List<Located<Obstacle>> named(List<Located<ObstacleReader.Entry>> entries) {
    Set<String> names = new HashSet<>();
    for (Located<ObstacleReader.Entry> entry : entries) {
      String name = entry.value().obstacle().name();
      if (!name.isEmpty() && !names.add(name)) {
        mistakes.add(entry.node(), Phrase.of("there are two obstacles of the name %s", name));
      }
    }
    List<String> given = named(entries.stream().map(Located::value).toList(), names);
    List<Located<Obstacle>> named = new ArrayList<>();
    for (int i = 0; i < given.size(); i++) {
      Obstacle obstacle = entries.get(i).value().obstacle();
      named.add(new Located<>(renamed(obstacle, given.get(i)), entries.get(i).node()));
    }
    return named;
  }

  /**
   * The names of obstacles; those without one get one that no other has: {@code box 1}.
   *
   * @param taken names of those that have one
   */
  static List<String> named(List<ObstacleReader.Entry> entries, Set<String> taken) {
    Set<String> names = new HashSet<>(taken);
    Map<String, Integer> counts = new HashMap<>();
    List<String> given = new ArrayList<>();
    for (ObstacleReader.Entry entry : entries) {
      String name = entry.obstacle().name();
      given.add(name.isEmpty() ? newName(entry.kind(), counts, names) : name);
    }
    return given;
  }

  /** A name that no other has: {@code box 1}. */
  private static String newName(String kind, Map<String, Integer> counts, Set<String> names) {
    String name;
    do {
      name = kind + " " + counts.merge(kind, 1, Integer::sum);
    } while (!names.add(name));
    return name;
  }

  static Obstacle renamed(Obstacle obstacle, String name) {
    return new Obstacle(
        name, obstacle.shape(), obstacle.foot(), obstacle.heading(), obstacle.cover());
  }

  void obstacles(List<Located<Obstacle>> obstacles) {
    for (Located<Obstacle> obstacle : obstacles) {
      if (!Footprint.inside(obstacle.value(), room)) {
        mistakes.add(
            obstacle.node(),
            Phrase.of("the obstacle %s is not in the room", obstacle.value().name()));
      }
    }
  }

  void posters(List<Located<Poster>> posters) {
    for (Located<Poster> poster : posters) {
      if (!Footprint.inside(poster.value(), room)) {
        mistakes.add(
            poster.node(),
            Phrase.of("the middle of the poster is not on %s", poster.value().surface().phrase()));
      }
    }
  }

  /** Those of which there is none before. */
  List<MissionPad> pads(List<Located<MissionPad>> pads) {
    Set<Integer> ids = new HashSet<>();
    List<MissionPad> different = new ArrayList<>();
    for (Located<MissionPad> pad : pads) {
      int id = pad.value().id();
      if (ids.add(id)) {
        different.add(pad.value());
      } else {
        mistakes.add(pad.node(), Phrase.of("there are two mission pads of the number %d", id));
      }
      if (!Footprint.inside(pad.value(), room)) {
        mistakes.add(
            pad.node(),
            Phrase.of("the mission pad %d is not on %s", id, pad.value().surface().phrase()));
      }
    }
    return different;
  }

  /** Where the drones stand; only those that were read without mistakes are looked at. */
  void starts(List<Located<DroneReader.Entry>> drones, Arena arena) {
    Obstacles obstacles = Obstacles.of(arena);
    for (int i = 0; i < drones.size(); i++) {
      Node node = drones.get(i).node();
      if (!drones.get(i).value().sound()) {
        continue;
      }
      int number = i + 1;
      Vec3 start = start(drones, i);
      if (!room.contains(start, DroneSpec.HULL)) {
        mistakes.add(node, Phrase.of("drone %d does not fit into the room there", number));
      }
      Optional<Obstacle> around = obstacles.around(start, DroneSpec.HULL);
      if (around.isPresent()) {
        mistakes.add(node, Phrase.of("drone %d is in %s", number, around.get().phrase()));
      }
      for (int j = 0; j < i; j++) {
        if (drones.get(j).value().sound()
            && start.distanceTo(start(drones, j)) < 2 * DroneSpec.HULL.radius()) {
          mistakes.add(node, Phrase.of("drone %d is in drone %d", number, j + 1));
        }
      }
    }
  }

  private static Vec3 start(List<Located<DroneReader.Entry>> drones, int index) {
    return drones.get(index).value().setup().start().position();
  }

  /** Where the drones take commands; drone 1 is taken to be at 127.0.0.1 if nothing is said. */
  void addresses(List<Located<DroneReader.Entry>> drones) {
    Map<String, Integer> taken = new HashMap<>();
    for (int i = 0; i < drones.size(); i++) {
      if (!drones.get(i).value().sound()) {
        continue;
      }
      int number = i + 1;
      Station station = drones.get(i).value().station();
      String host =
          station.address().isPresent()
              ? station.address().get().getHostAddress()
              : "127.0.0." + number;
      Integer other = taken.putIfAbsent(host + ":" + station.port().orElse(0), number);
      if (other != null) {
        mistakes.add(
            drones.get(i).node(),
            Phrase.of("drone %d takes commands where drone %d does", number, other));
      }
    }
  }

  /** What goals name; only what was read without mistakes is looked for. */
  void goals(List<Located<Goal>> goals, Arena arena, Whole whole) {
    for (Located<Goal> goal : goals) {
      if (goal.value() instanceof Goal.Reach reach) {
        place(goal.node(), reach.spot());
      } else if (goal.value() instanceof Goal.Hover hover) {
        place(goal.node(), hover.spot());
      } else if (goal.value() instanceof Goal.Land land) {
        place(goal.node(), land.spot());
      } else if (goal.value() instanceof Goal.Pass pass && whole.obstacles()) {
        gate(goal.node(), pass.gate(), arena.obstacles());
      } else if (goal.value() instanceof Goal.LandOn land && whole.pads()) {
        pad(goal.node(), land.pad(), arena.pads());
      }
    }
  }

  private void place(Node node, Spot spot) {
    if (!Footprint.inside(spot.place(), room)) {
      mistakes.add(node, Phrase.of("this place is not in the room"));
    }
  }

  private void gate(Node node, String name, List<Obstacle> obstacles) {
    Optional<Obstacle> named =
        obstacles.stream().filter(obstacle -> obstacle.name().equals(name)).findFirst();
    if (named.isPresent()) {
      if (!(named.get().shape() instanceof Shape.Gate)) {
        mistakes.add(node, Phrase.of("the obstacle %s is no gate", name));
      }
      return;
    }
    Set<String> gates =
        obstacles.stream()
            .filter(obstacle -> obstacle.shape() instanceof Shape.Gate)
            .map(Obstacle::name)
            .collect(Collectors.toSet());
    String shown = Values.shown(name);
    mistakes.add(
        node,
        Spelling.meant(name, gates)
            .map(meant -> Phrase.of("there is no gate %s, did you mean %s?", shown, meant))
            .orElseGet(() -> Phrase.of("there is no gate %s", shown)));
  }

  private void pad(Node node, int id, List<MissionPad> pads) {
    boolean lies = pads.stream().anyMatch(pad -> pad.id() == id && pad.surface() == Surface.FLOOR);
    if (!lies) {
      mistakes.add(node, Phrase.of("no mission pad %d lies on the floor", id));
    }
  }
}
