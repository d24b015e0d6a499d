package tellosimulator.scenario;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.Tag;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.Spot;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.profile.Behaviour;
import tellosimulator.profile.Profile;
import tellosimulator.scenario.Scenario.Station;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.Outlets;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;
import tellosimulator.world.Wind;

/** Writes a whole scenario. */
final class ScenarioWriter {

  private final Path folder;

  /**
   * @param folder in which the file will be
   */
  ScenarioWriter(Path folder) {
    this.folder = folder;
  }

  /** A text in which what is as usual is left out. */
  String text(Scenario scenario) {
    List<Notation> notations =
        scenario.config().arena().obstacles().stream().map(Notation::usual).toList();
    return Yaml.text(node(scenario, notations));
  }

  /**
   * All that a file can say of a scenario.
   *
   * @param notations how its obstacles are written, in their order
   */
  Node node(Scenario scenario, List<Notation> notations) {
    SimConfig config = scenario.config();
    Arena arena = config.arena();
    Yaml file = Yaml.block();
    file.put("name", scenario.name(), "").put("teaches", scenario.teaches(), "");
    room(file, arena);
    obstacles(file, arena.obstacles(), notations);
    file.list("pads", arena.pads().stream().map(ScenarioWriter::pad).toList());
    drones(file, scenario);
    wind(file, arena.wind());
    file.put("crash-speed", config.rules().crashSpeed() * 100, DroneSpec.CRASH_SPEED * 100);
    if (config.timeFactor().unlimited()) {
      file.put("time-factor", ScenarioReader.MAX);
    } else {
      file.put("time-factor", config.timeFactor().value(), TimeFactor.REAL_TIME.value());
    }
    String usualSeed = Long.toString(SimConfig.DEFAULT.seed());
    file.plain("seed", Tag.INT, Long.toString(config.seed()), usualSeed);
    challenge(file, scenario.challenge());
    return file.node();
  }

  private void obstacles(Yaml file, List<Obstacle> obstacles, List<Notation> notations) {
    ObstacleWriter writer = new ObstacleWriter(folder);
    List<Yaml> written = new ArrayList<>();
    for (int i = 0; i < obstacles.size(); i++) {
      written.add(writer.written(obstacles.get(i), notations.get(i)));
    }
    file.list("obstacles", written);
  }

  private void room(Yaml file, Arena arena) {
    Room room = arena.room();
    Decor decor = arena.decor();
    file.put(
        "room",
        Yaml.line()
            .put("width", room.width() * 100)
            .put("depth", room.depth() * 100)
            .put("height", room.height() * 100));
    file.put("grid", decor.grid() * 100, Decor.DEFAULT.grid() * 100);
    file.put("walls", decor.walls().option(), Decor.DEFAULT.walls().option());
    file.list("posters", decor.posters().stream().map(this::poster).toList());
  }

  private Yaml poster(Poster poster) {
    return Yaml.line()
        .put("wall", key(RoomReader.SURFACES, poster.surface()))
        .put("along", poster.along() * 100)
        .put("height", poster.height() * 100)
        .put("width", poster.width() * 100)
        .put("picture", Pictures.from(folder, poster.picture()));
  }

  private static Yaml pad(MissionPad pad) {
    Yaml written = Yaml.line();
    double turnedDeg = degrees(pad.rotation());
    written.put("id", pad.id());
    if (pad.surface() == Surface.FLOOR) {
      Vec3 place = pad.pose(Room.DEFAULT).position();
      return written.put("at", point(place)).put("heading", turnedDeg, 0);
    }
    return written
        .put("wall", key(RoomReader.PAD_WALLS, pad.surface()))
        .put("along", pad.along() * 100)
        .put("height", pad.height() * 100)
        .put("rotation", turnedDeg, 0);
  }

  private static void drones(Yaml file, Scenario scenario) {
    List<DroneSetup> setups = scenario.config().drones();
    List<Yaml> drones = new ArrayList<>();
    for (int i = 0; i < setups.size(); i++) {
      drones.add(drone(setups.get(i), scenario.stations().get(i)));
    }
    file.list("drones", drones);
  }

  private static Yaml drone(DroneSetup setup, Station station) {
    Product product = setup.product();
    Outlets outlets = setup.outlets();
    Yaml drone = Yaml.line();
    drone
        .put("start", point(setup.start().position()))
        .put("heading", degrees(setup.start().attitude().heading()), 0)
        .put("profile", product.profile().option(), Profile.EDU.option())
        .put("behaviour", product.behaviour().option(), Behaviour.REPORT.option());
    setup.rgb().ifPresent(rgb -> drone.put("colour", colour(rgb)));
    drone.put("battery", setup.batteryPercent(), 100);
    station.address().ifPresent(address -> drone.put("address", address.getHostAddress()));
    station.port().ifPresent(port -> drone.put("command-port", port));
    return drone
        .put("state-port", outlets.statePort(), Outlets.DEFAULT.statePort())
        .put("video-port", outlets.videoPort(), Outlets.DEFAULT.videoPort());
  }

  private static void wind(Yaml file, Wind wind) {
    Vec3 mean = wind.mean();
    double speed = mean.norm();
    double towardsDeg = speed == 0 ? 0 : degrees(StrictMath.atan2(mean.y(), mean.x()));
    Node written =
        Yaml.line()
            .put("towards", towardsDeg, 0)
            .put("speed", speed * 100, 0)
            .put("gusts", wind.gusts() * 100, 0)
            .node();
    file.put("wind", Yaml.marked(written, wind.equals(Wind.CALM)));
  }

  private static void challenge(Yaml file, Challenge challenge) {
    file.list("goals", challenge.goals().stream().map(ScenarioWriter::goal).toList());
    file.plain("in-order", Tag.BOOL, Boolean.toString(challenge.inOrder()), "false");
    challenge.timeLimit().ifPresent(limit -> file.put("time-limit", limit));
    String allowed = key(ScenarioReader.TOUCH, false);
    file.put("touch", key(ScenarioReader.TOUCH, challenge.untouched()), allowed);
  }

  private static Yaml goal(Goal goal) {
    Yaml written = Yaml.line();
    String kind;
    if (goal instanceof Goal.Reach reach) {
      kind = "reach";
      spot(written, reach.spot(), space(reach.spot().place()));
    } else if (goal instanceof Goal.Hover hover) {
      kind = "hover";
      spot(written, hover.spot(), space(hover.spot().place())).put("seconds", hover.seconds());
    } else if (goal instanceof Goal.Pass pass) {
      kind = "pass";
      String direction = key(GoalReader.DIRECTIONS, pass.direction());
      written.put("gate", pass.gate());
      written.put("direction", direction, key(GoalReader.DIRECTIONS, Goal.Direction.EITHER));
    } else if (goal instanceof Goal.Land land) {
      kind = "land";
      spot(written, land.spot(), point(land.spot().place()));
    } else {
      kind = "land-on";
      written.put("pad", ((Goal.LandOn) goal).pad());
    }
    goal.drone().ifPresent(drone -> written.put("drone", drone));
    return Yaml.block().put(kind, written);
  }

  private static Yaml spot(Yaml goal, Spot spot, Node at) {
    return goal.put("at", at).put("radius", spot.radius() * 100);
  }

  /** A place on the floor. */
  static Node point(Vec3 place) {
    return Yaml.numbers(place.x() * 100, place.y() * 100);
  }

  private static Node space(Vec3 place) {
    return Yaml.numbers(place.x() * 100, place.y() * 100, place.z() * 100);
  }

  /** Above -180 and up to 180, as they are read. */
  static double degrees(double radians) {
    double degrees = Values.rounded(StrictMath.toDegrees(Frames.wrapped(radians)));
    return degrees == -180 ? 180 : degrees;
  }

  /** By its name, if it has one. */
  static String colour(int rgb) {
    return Colours.BY_NAME.entrySet().stream()
        .filter(named -> named.getValue() == rgb)
        .map(Map.Entry::getKey)
        .findFirst()
        .orElseGet(() -> String.format(Locale.ROOT, "#%06x", rgb));
  }

  /** The word for a value. */
  static <T> String key(Map<String, T> words, T value) {
    return words.entrySet().stream()
        .filter(entry -> entry.getValue().equals(value))
        .map(Map.Entry::getKey)
        .findFirst()
        .orElseThrow();
  }
}
