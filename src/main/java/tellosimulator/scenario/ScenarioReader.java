package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.model.DroneSpec;
import tellosimulator.scenario.Scenario.Station;
import tellosimulator.scenario.Section.Located;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.Rules;
import tellosimulator.time.TimeFactor;
import tellosimulator.words.Phrase;
import tellosimulator.world.Arena;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;
import tellosimulator.world.Wind;

/** Reads a whole scenario. */
final class ScenarioReader {

  /** How many there may be. Decided: more than can be seen, or flown. */
  private static final int MOST_OBSTACLES = 10_000;

  private static final int MOST_DRONES = 250;
  private static final int MOST_OTHERS = 1000;

  /** The fastest touch that may be none [cm/s]. Decided: no drone gets there, so nothing is one. */
  private static final double FASTEST_TOUCH = 2000;

  static final Map<String, Boolean> TOUCH = Map.of("forbidden", true, "allowed", false);

  /** The time factor that is none. */
  static final String MAX = "max";

  private final Section scenario;
  private final Pictures images;
  private final Mistakes mistakes;

  /**
   * @param images that it names
   */
  ScenarioReader(Node root, Pictures images, Mistakes mistakes) {
    this.scenario = Section.of(Kind.SCENARIO, root, mistakes);
    this.images = images;
    this.mistakes = mistakes;
  }

  /** The scenario; it is good for nothing if there were mistakes. */
  Scenario read() {
    Room room = scenario.read("room", RoomReader::room, Room.DEFAULT);
    Checks checks = new Checks(room, mistakes);
    int before = mistakes.count();
    List<Located<Obstacle>> obstacles =
        checks.named(scenario.list("obstacles", MOST_OBSTACLES, new ObstacleReader(images)));
    boolean allObstacles = mistakes.count() == before;
    checks.obstacles(obstacles);
    before = mistakes.count();
    List<Located<MissionPad>> pads = scenario.list("pads", MOST_OTHERS, RoomReader::pad);
    boolean allPads = mistakes.count() == before;
    Arena arena =
        furnished(room, checks).withObstacles(values(obstacles)).withPads(checks.pads(pads));
    List<Located<DroneReader.Entry>> drones = drones();
    checks.starts(drones, arena);
    checks.addresses(drones);
    SimConfig config = config(arena, drones);
    List<Located<Goal>> goals =
        scenario.list("goals", MOST_OTHERS, new GoalReader(config.drones().size()));
    checks.goals(goals, arena, new Checks.Whole(allObstacles, allPads));
    return new Scenario(
        scenario.read("name", Values.text(), ""),
        scenario.read("teaches", Values.text(), ""),
        config,
        stations(drones),
        challenge(values(goals)));
  }

  /** Those of the file, or the usual one. */
  private List<Located<DroneReader.Entry>> drones() {
    List<Located<DroneReader.Entry>> drones =
        scenario.list("drones", MOST_DRONES, new DroneReader());
    DroneReader.Entry usual =
        new DroneReader.Entry(SimConfig.DEFAULT.drones().get(0), Station.USUAL, true);
    return drones.isEmpty() ? List.of(new Located<>(usual, scenario.node())) : drones;
  }

  /** All that is in the room but obstacles and mission pads. */
  private Arena furnished(Room room, Checks checks) {
    List<Located<Poster>> posters =
        scenario.list("posters", MOST_OTHERS, RoomReader.poster(images));
    checks.posters(posters);
    return Arena.empty(room, RoomReader.decor(scenario, values(posters)))
        .withWind(scenario.read("wind", RoomReader::wind, Wind.CALM));
  }

  private SimConfig config(Arena arena, List<Located<DroneReader.Entry>> drones) {
    List<DroneSetup> setups = new ArrayList<>();
    for (Located<DroneReader.Entry> drone : drones) {
      setups.add(drone.value().setup());
    }
    TimeFactor factor =
        scenario.read("time-factor", ScenarioReader::timeFactor, TimeFactor.REAL_TIME);
    Value<Long> seed =
        Values.whole(
            Phrase.of("a whole number of at most 18 digits"), Long.MIN_VALUE, Long.MAX_VALUE);
    return new SimConfig(
        arena,
        setups,
        factor,
        scenario.read("seed", seed, SimConfig.DEFAULT.seed()),
        Rules.DEFAULT.withCrashSpeed(
            scenario.read("crash-speed", Values.speed(FASTEST_TOUCH), DroneSpec.CRASH_SPEED)));
  }

  private static List<Station> stations(List<Located<DroneReader.Entry>> drones) {
    List<Station> stations = new ArrayList<>();
    for (Located<DroneReader.Entry> drone : drones) {
      stations.add(drone.value().station());
    }
    return stations;
  }

  private static Optional<TimeFactor> timeFactor(Node node, Mistakes mistakes) {
    if (node instanceof ScalarNode scalar && scalar.getValue().equals(MAX)) {
      return Optional.of(TimeFactor.MAX);
    }
    return Values.number(
            Phrase.of(
                "a time factor from %s to %s, or max",
                Values.plain(TimeFactor.SMALLEST), Values.plain(TimeFactor.LARGEST)),
            TimeFactor.SMALLEST,
            TimeFactor.LARGEST)
        .read(node, mistakes)
        .map(TimeFactor::new);
  }

  private Challenge challenge(List<Goal> goals) {
    Value<Double> limit =
        Values.number(
            Phrase.of("seconds from 1 to %s", Values.plain(Challenge.LONGEST)),
            1,
            Challenge.LONGEST);
    Optional<Double> seconds = scenario.read("time-limit", limit);
    return new Challenge(
        goals,
        scenario.read("in-order", Values.yesOrNo(), false),
        seconds.isPresent() ? OptionalDouble.of(seconds.get()) : OptionalDouble.empty(),
        scenario.read("touch", Values.word(TOUCH), false));
  }

  private static <T> List<T> values(List<Located<T>> located) {
    List<T> values = new ArrayList<>(located.size());
    for (Located<T> each : located) {
      values.add(each.value());
    }
    return values;
  }
}
