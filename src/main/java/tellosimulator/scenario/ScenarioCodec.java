package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.snakeyaml.engine.v2.common.FlowStyle;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.NodeTuple;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.SequenceNode;
import tellosimulator.fault.Fault;
import tellosimulator.fault.FaultPlan;
import tellosimulator.fault.LinkPreset;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.Scoring;
import tellosimulator.model.DroneSpec;
import tellosimulator.network.AddressPlan;
import tellosimulator.scenario.Codec.Composed;
import tellosimulator.scenario.ListCodec.Item;
import tellosimulator.scenario.Scenario.CommandAddress;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.Rules;
import tellosimulator.time.TimeFactor;
import tellosimulator.words.Phrase;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;
import tellosimulator.world.Walls;
import tellosimulator.world.Wind;

/** Codec of a whole scenario. */
final class ScenarioCodec extends RecordCodec<ScenarioCodec.ParsedScenario> {

  /**
   * A scenario together with its form in a file.
   *
   * @param notations the forms of the obstacles, in their order
   */
  record ParsedScenario(Scenario scenario, List<SourceForm> notations) {

    /**
     * Returns the parsed form of a scenario that is not in a file yet. All obstacles have their
     * default forms.
     */
    static ParsedScenario usual(Scenario scenario) {
      List<Obstacle> obstacles = scenario.config().arena().obstacles();
      return new ParsedScenario(scenario, obstacles.stream().map(SourceForm::usual).toList());
    }

    private Description description() {
      return scenario.description();
    }

    private SimConfig config() {
      return scenario.config();
    }

    private Arena arena() {
      return config().arena();
    }

    private List<ObstacleCodecs.ParsedObstacle> obstacles() {
      List<ObstacleCodecs.ParsedObstacle> entries = new ArrayList<>();
      for (Obstacle obstacle : arena().obstacles()) {
        entries.add(new ObstacleCodecs.ParsedObstacle(notations.get(entries.size()), obstacle));
      }
      return entries;
    }

    private List<DroneCodec.DronePlacement> drones() {
      List<DroneCodec.DronePlacement> entries = new ArrayList<>();
      for (CommandAddress station : scenario.stations()) {
        entries.add(new DroneCodec.DronePlacement(config().drones().get(entries.size()), station));
      }
      return entries;
    }
  }

  /** Maximum number of obstacles. Decided: far more than a useful room contains. */
  private static final int MOST_OBSTACLES = 10_000;

  /**
   * Maximum number of posters, mission pads, faults or goals. Decided: more than any scenario
   * needs.
   */
  private static final int MOST_OTHERS = 1000;

  /**
   * Placeholder for a room that could not be read. It has the maximum size, so that no object is
   * reported as being outside.
   */
  private static final Room UNKNOWN = new Room(Room.LONGEST, Room.LONGEST, Room.LONGEST);

  private static final DroneCodec.DronePlacement USUAL_DRONE =
      new DroneCodec.DronePlacement(SimConfig.DEFAULT.drones().get(0), CommandAddress.USUAL);

  /** The codec for all scenario files. */
  static final ScenarioCodec CODEC = new ScenarioCodec();

  private final Field<ParsedScenario, LocalizedText> name =
      key("name", "Name of the scenario.")
          .optional(new LocalizedTextCodec(), noted -> written(noted.description().name()));
  private final Field<ParsedScenario, LocalizedText> teaches =
      key("teaches", "What users learn from it, in one line.")
          .optional(new LocalizedTextCodec(), noted -> written(noted.description().teaches()));
  private final Field<ParsedScenario, Difficulty> difficulty =
      key("difficulty", "Difficulty of writing a program for it.")
          .optional(WordCodec.of(Difficulty.values()), noted -> noted.description().difficulty());
  private final Field<ParsedScenario, Room> room =
      key("room", "")
          .usual(RoomCodecs.room().orWritten(Room.DEFAULT), noted -> noted.arena().room());
  private final Field<ParsedScenario, Double> grid =
      key("grid", "Distance between the lines on the floor in cm.")
          .usual(
              NumberCodec.length(Quantity.GRID).or(Decor.DEFAULT.grid()),
              noted -> noted.arena().decor().grid());
  private final Field<ParsedScenario, Walls> walls =
      key(
              "walls",
              "Covering of floor, walls and ceiling; auto is parquet and plaster,"
                  + " with windows and a door.")
          .usual(
              WordCodec.of(Walls.values()).or(Decor.DEFAULT.walls()),
              noted -> noted.arena().decor().walls());
  private final Field<ParsedScenario, Integer> accent =
      key("accent", "Colour of the front wall.")
          .optionalInt(Scalars.COLOR, noted -> noted.arena().decor().accent());
  private final Field<ParsedScenario, List<Item<Poster>>> posters =
      key("posters", "Images on the walls.")
          .usual(
              new ListCodec<>(RoomCodecs.poster(), MOST_OTHERS).or(List.of()),
              noted -> Item.of(noted.arena().decor().posters()));
  private final Field<ParsedScenario, List<Item<ObstacleCodecs.ParsedObstacle>>> obstacles =
      key("obstacles", "Obstacles that stand and hang in the room.")
          .usual(
              new ListCodec<>(ObstacleCodecs.obstacle(), MOST_OBSTACLES).or(List.of()),
              noted -> Item.of(noted.obstacles()));
  private final Field<ParsedScenario, List<Item<MissionPad>>> pads =
      key("pads", "Mission pads, each number once.")
          .usual(
              new ListCodec<>(RoomCodecs.pad(), MOST_OTHERS).or(List.of()),
              noted -> Item.of(noted.arena().pads()));
  private final Field<ParsedScenario, List<Item<DroneCodec.DronePlacement>>> drones =
      key("drones", "The drones; without them, one in the room's centre.")
          .usual(
              new ListCodec<>(new DroneCodec(), AddressPlan.MOST_DRONES).or(List.of()),
              noted -> Item.of(noted.drones()));
  private final Field<ParsedScenario, Wind> wind =
      key("wind", "").usual(RoomCodecs.wind().or(Wind.CALM), noted -> noted.arena().wind());
  private final Field<ParsedScenario, LinkPreset> link =
      key("link", "Quality of the radio link. Default: that of each drone's behaviour.")
          .optional(
              WordCodec.of(LinkPreset.values()), noted -> noted.config().rules().faults().link());
  private final Field<ParsedScenario, List<Item<Fault>>> faults =
      key("faults", "Faults.")
          .usual(
              new ListCodec<>(new FaultCodec(), MOST_OTHERS).or(List.of()),
              noted -> Item.of(noted.config().rules().faults().faults()));
  private final Field<ParsedScenario, Double> crashSpeed =
      key(
              "crash-speed",
              "Maximum speed in cm/s at which a drone may touch something without a crash.")
          .usual(
              NumberCodec.speed(Quantity.CRASH_SPEED).or(DroneSpec.CRASH_SPEED),
              noted -> noted.config().rules().crashSpeed());
  private final Field<ParsedScenario, TimeFactor> timeFactor =
      key(
              "time-factor",
              "Speed of simulated time: 5 is five times as fast; max is as fast as the machine can"
                  + " while a drone moves.")
          .usual(timeFactor().or(TimeFactor.REAL_TIME), noted -> noted.config().timeFactor());
  private final Field<ParsedScenario, Long> seed =
      key("seed", "The same seed and the same commands give the same flight.")
          .usual(Scalars.SEED.or(SimConfig.DEFAULT.seed()), noted -> noted.config().seed());
  private final Field<ParsedScenario, List<Item<Goal>>> goals =
      key("goals", "Goals of the drones.")
          .usual(
              new ListCodec<>(GoalCodecs.goal(), MOST_OTHERS).or(List.of()),
              noted -> Item.of(noted.scenario().challenge().goals()));
  private final Field<ParsedScenario, Boolean> inOrder =
      key("in-order", "Whether goals must be reached in their order.")
          .usual(Scalars.YES_OR_NO.or(false), noted -> noted.scenario().challenge().inOrder());
  private final Field<ParsedScenario, Double> timeLimit =
      key("time-limit", "Maximum time in seconds, counted from the first takeoff.")
          .optional(
              NumberCodec.seconds(Quantity.TIME_LIMIT),
              noted -> boxed(noted.scenario().challenge().timeLimit()));
  private final Field<ParsedScenario, Boolean> untouched =
      key(
              "touch",
              "Whether the task fails when a drone touches anything in flight. A crash always"
                  + " fails.")
          .usual(
              new WordCodec<>(Map.of("forbidden", true, "allowed", false)).or(false),
              noted -> noted.scenario().challenge().untouched());

  private final Field<ParsedScenario, Scoring> scoring =
      key("scoring", "")
          .optional(new ScoringCodec(), noted -> noted.scenario().challenge().scoring());

  private ScenarioCodec() {
    super(
        "scenario",
        Phrase.of("a scenario"),
        "A room with its obstacles, drones and goals. Lengths in cm, angles in degrees, speeds in"
            + " cm/s.");
    made(this::make);
  }

  private static Optional<LocalizedText> written(LocalizedText text) {
    return text.isEmpty() ? Optional.empty() : Optional.of(text);
  }

  private static Optional<Double> boxed(OptionalDouble value) {
    return value.isPresent() ? Optional.of(value.getAsDouble()) : Optional.empty();
  }

  @Override
  FlowStyle style() {
    return FlowStyle.BLOCK;
  }

  /**
   * Reads a scenario, even if its parts contradict each other; contradictions are reported as
   * errors.
   */
  @Override
  public Optional<ParsedScenario> read(Node node, Context context) {
    Entries in = entries(node, context.withDrones(drones(node)));
    boolean sound = in.sound();
    checkParts(in, !context.draw().isEmpty());
    return sound ? Optional.of(make(in)) : Optional.empty();
  }

  /**
   * Counts the drones in a file without reading them. Returns 1 if the file lists no drones or too
   * many.
   */
  private int drones(Node root) {
    int written = 0;
    if (root instanceof MappingNode mapping) {
      for (NodeTuple tuple : mapping.getValue()) {
        if (tuple.getKeyNode() instanceof ScalarNode key
            && key.getValue().equals(drones.key())
            && tuple.getValueNode() instanceof SequenceNode list) {
          written = list.getValue().size();
        }
      }
    }
    return written <= AddressPlan.MOST_DRONES ? Math.max(1, written) : 1;
  }

  /**
   * @param drawn whether the file contains ranges; fixed rooms may be odd on purpose
   */
  private void checkParts(Entries in, boolean drawn) {
    ScenarioValidator checks =
        new ScenarioValidator(in.find(room).orElse(UNKNOWN), in.diagnostics());
    List<Item<ObstacleCodecs.ParsedObstacle>> written = in.find(obstacles).orElse(List.of());
    List<Item<Obstacle>> named = named(written);
    List<Item<MissionPad>> placed = in.find(pads).orElse(List.of());
    checks.names(written);
    checks.obstacles(named);
    checks.posters(in.find(posters).orElse(List.of()));
    checks.pads(placed);
    checks.starts(flying(in), Item.values(named));
    checks.addresses(flying(in));
    List<Item<Goal>> wanted = in.find(goals).orElse(List.of());
    checks.places(wanted);
    checks.reachable(wanted, Item.values(placed), Item.values(named));
    if (in.sound(obstacles)) {
      checks.gates(wanted, Item.values(named));
    }
    if (in.sound(pads)) {
      checks.padsToLandOn(wanted, Item.values(placed));
      checks.padsToSee(wanted, Item.values(placed));
    }
    if (in.sound(posters)) {
      checks.postersToSee(wanted, Item.values(in.find(posters).orElse(List.of())));
    }
    if (drawn) {
      checks.overlaps(written, named);
      checks.covered(placed, Item.values(named));
      checks.passable(wanted, Item.values(named));
    }
  }

  private static List<Item<Obstacle>> named(List<Item<ObstacleCodecs.ParsedObstacle>> written) {
    List<String> names = ObstacleCodecs.names(Item.values(written));
    List<Item<Obstacle>> named = new ArrayList<>();
    for (Item<ObstacleCodecs.ParsedObstacle> item : written) {
      named.add(item.with(item.value().obstacle().named(names.get(named.size()))));
    }
    return named;
  }

  /**
   * Returns the drones of a file. If the file contains none, returns the default drone; errors
   * about it refer to the beginning of the file.
   */
  private List<Item<DroneCodec.DronePlacement>> flying(Entries in) {
    List<Item<DroneCodec.DronePlacement>> written = in.find(drones).orElse(List.of());
    return written.isEmpty() && in.sound(drones)
        ? List.of(new Item<>(USUAL_DRONE, 1, Diagnostics.place(in.node()), false))
        : written;
  }

  private ParsedScenario make(Entries in) {
    Map<Integer, MissionPad> padsById = new LinkedHashMap<>();
    in.get(pads).forEach(pad -> padsById.putIfAbsent(pad.value().id(), pad.value()));
    Arena arena =
        new Arena(
            in.get(room),
            new Decor(
                in.get(grid), in.get(walls), in.findInt(accent), Item.values(in.get(posters))),
            Item.values(named(in.get(obstacles))),
            List.copyOf(padsById.values()),
            in.get(wind));
    List<DroneCodec.DronePlacement> flying = Item.values(flying(in));
    SimConfig config =
        new SimConfig(
            arena,
            flying.stream().map(DroneCodec.DronePlacement::setup).toList(),
            in.get(timeFactor),
            in.get(seed),
            Rules.DEFAULT
                .withCrashSpeed(in.get(crashSpeed))
                .withFaults(new FaultPlan(in.find(link), Item.values(in.get(faults)))));
    Optional<Double> limit = in.find(timeLimit);
    Challenge challenge =
        new Challenge(
            Item.values(in.get(goals)),
            in.get(inOrder),
            limit.isPresent() ? OptionalDouble.of(limit.get()) : OptionalDouble.empty(),
            in.get(untouched),
            in.find(scoring));
    Scenario scenario =
        new Scenario(
            new Description(
                in.find(name).orElse(LocalizedText.NONE),
                in.find(teaches).orElse(LocalizedText.NONE),
                in.find(difficulty)),
            config,
            flying.stream().map(DroneCodec.DronePlacement::station).toList(),
            challenge);
    return new ParsedScenario(
        scenario, in.get(obstacles).stream().map(item -> item.value().notation()).toList());
  }

  /** Returns the JSON schema by which editors check scenario files. */
  Map<String, Object> jsonSchema() {
    return document("Scenario of the Tello Simulator");
  }

  /** Returns the codec of a time factor, which is a number or a word. */
  private static Codec<TimeFactor> timeFactor() {
    String max = "max";
    NumberCodec number =
        new NumberCodec(
            Quantity.TIME_FACTOR,
            Phrase.of(
                "a time factor from %s to %s, or max",
                NumberCodec.plain(TimeFactor.SMALLEST), NumberCodec.plain(TimeFactor.LARGEST)));
    return new Composed<>(
        (node, context) ->
            Scalars.text(node).filter(max::equals).isPresent()
                ? Optional.of(TimeFactor.MAX)
                : number.read(node, context).map(TimeFactor::new),
        (factor, folder) ->
            factor.unlimited() ? Yaml.text(max) : number.write(factor.value(), folder),
        definitions ->
            Codec.object("anyOf", List.of(Codec.object("const", max), number.schema(definitions))));
  }
}
