package tellosimulator.scenario;

import java.nio.file.Path;
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
import tellosimulator.model.DroneSpec;
import tellosimulator.network.AddressPlan;
import tellosimulator.scenario.ListCodec.Item;
import tellosimulator.scenario.Scenario.Station;
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

/** A whole scenario. */
final class ScenarioCodec extends RecordCodec<ScenarioCodec.Noted> {

  /**
   * A scenario and how a file writes it.
   *
   * @param notations of its obstacles, in their order
   */
  record Noted(Scenario scenario, List<Notation> notations) {

    /** One that no file has yet. */
    static Noted usual(Scenario scenario) {
      List<Obstacle> obstacles = scenario.config().arena().obstacles();
      return new Noted(scenario, obstacles.stream().map(Notation::usual).toList());
    }

    /** The same for a scenario that is written in the same way. */
    Noted of(Scenario other) {
      List<Obstacle> obstacles = other.config().arena().obstacles();
      List<Notation> theirs = new ArrayList<>();
      for (Notation notation : notations) {
        theirs.add(notation.of(obstacles.get(theirs.size())));
      }
      return new Noted(other, theirs);
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

    private List<ObstacleCodecs.NotedObstacle> obstacles() {
      List<ObstacleCodecs.NotedObstacle> entries = new ArrayList<>();
      for (Obstacle obstacle : arena().obstacles()) {
        entries.add(new ObstacleCodecs.NotedObstacle(notations.get(entries.size()), obstacle));
      }
      return entries;
    }

    private List<DroneCodec.StationedDrone> drones() {
      List<DroneCodec.StationedDrone> entries = new ArrayList<>();
      for (Station station : scenario.stations()) {
        entries.add(new DroneCodec.StationedDrone(config().drones().get(entries.size()), station));
      }
      return entries;
    }
  }

  /** How many there may be. Decided: more than can be seen, or flown. */
  private static final int MOST_OBSTACLES = 10_000;

  private static final int MOST_OTHERS = 1000;

  /** What stands for a room until the mistake is told; everything is in it. */
  private static final Room UNKNOWN = new Room(Room.LONGEST, Room.LONGEST, Room.LONGEST);

  private static final DroneCodec.StationedDrone USUAL_DRONE =
      new DroneCodec.StationedDrone(SimConfig.DEFAULT.drones().get(0), Station.USUAL);

  /** Reads, writes and describes all scenario files. */
  static final ScenarioCodec CODEC = new ScenarioCodec();

  private final Field<Noted, LocalizedText> name =
      key("name", "What the scenario is called.")
          .optional(new LocalizedTextCodec(), noted -> written(noted.description().name()));
  private final Field<Noted, LocalizedText> teaches =
      key("teaches", "What one learns by it, in a line.")
          .optional(new LocalizedTextCodec(), noted -> written(noted.description().teaches()));
  private final Field<Noted, Difficulty> difficulty =
      key("difficulty", "How much it asks of who programs for it.")
          .optional(WordCodec.of(Difficulty.values()), noted -> noted.description().difficulty());
  private final Field<Noted, Room> room =
      key("room", "")
          .usual(RoomCodecs.room().orWritten(Room.DEFAULT), noted -> noted.arena().room());
  private final Field<Noted, Double> grid =
      key("grid", "Distance between the lines on the floor in cm.")
          .usual(
              NumberCodec.length(Decor.SMALLEST_GRID * 100, Decor.LARGEST_GRID * 100)
                  .or(Decor.DEFAULT.grid()),
              noted -> noted.arena().decor().grid());
  private final Field<Noted, Walls> walls =
      key(
              "walls",
              "What floor, walls and ceiling are covered with; auto is textured in the drones' film"
                  + " and calm in the window.")
          .usual(
              WordCodec.of(Walls.values()).or(Decor.DEFAULT.walls()),
              noted -> noted.arena().decor().walls());
  private final Field<Noted, Integer> accent =
      key(
              "accent",
              "The colour of the front wall in the window's calm room, and of its bricks in the"
                  + " drones' film.")
          .optionalInt(Scalars.COLOR, noted -> noted.arena().decor().accent());
  private final Field<Noted, List<Item<Poster>>> posters =
      key("posters", "Images on the walls.")
          .usual(
              new ListCodec<>(RoomCodecs.poster(), MOST_OTHERS).or(List.of()),
              noted -> Item.of(noted.arena().decor().posters()));
  private final Field<Noted, List<Item<ObstacleCodecs.NotedObstacle>>> obstacles =
      key("obstacles", "What stands and hangs in the room.")
          .usual(
              new ListCodec<>(ObstacleCodecs.obstacle(), MOST_OBSTACLES).or(List.of()),
              noted -> Item.of(noted.obstacles()));
  private final Field<Noted, List<Item<MissionPad>>> pads =
      key("pads", "Mission pads, each number once.")
          .usual(
              new ListCodec<>(RoomCodecs.pad(), MOST_OTHERS).or(List.of()),
              noted -> Item.of(noted.arena().pads()));
  private final Field<Noted, List<Item<DroneCodec.StationedDrone>>> drones =
      key("drones", "The drones; without them, one in the room's centre.")
          .usual(
              new ListCodec<>(new DroneCodec(), AddressPlan.MOST_DRONES).or(List.of()),
              noted -> Item.of(noted.drones()));
  private final Field<Noted, Wind> wind =
      key("wind", "").usual(RoomCodecs.wind().or(Wind.CALM), noted -> noted.arena().wind());
  private final Field<Noted, LinkPreset> link =
      key("link", "How good the link is; without it, as the behaviour of each drone has it.")
          .optional(
              WordCodec.of(LinkPreset.values()), noted -> noted.config().rules().faults().link());
  private final Field<Noted, List<Item<Fault>>> faults =
      key("faults", "What goes wrong.")
          .usual(
              new ListCodec<>(new FaultCodec(), MOST_OTHERS).or(List.of()),
              noted -> Item.of(noted.config().rules().faults().faults()));
  private final Field<Noted, Double> crashSpeed =
      key("crash-speed", "How fast [cm/s] a drone may touch something before it is a crash.")
          .usual(
              NumberCodec.speed(Rules.FASTEST_TOUCH * 100).or(DroneSpec.CRASH_SPEED),
              noted -> noted.config().rules().crashSpeed());
  private final Field<Noted, TimeFactor> timeFactor =
      key(
              "time-factor",
              "How fast time passes: 5 is five times as fast; max is as fast as the machine can"
                  + " while a drone moves.")
          .usual(
              new TimeFactorCodec().or(TimeFactor.REAL_TIME), noted -> noted.config().timeFactor());
  private final Field<Noted, Long> seed =
      key("seed", "The same seed and the same commands give the same flight.")
          .usual(
              Scalars.whole(
                      Phrase.of("a whole number of at most 18 digits"),
                      -999_999_999_999_999_999L,
                      999_999_999_999_999_999L)
                  .or(SimConfig.DEFAULT.seed()),
              noted -> noted.config().seed());
  private final Field<Noted, List<Item<Goal>>> goals =
      key("goals", "What the drones shall do.")
          .usual(
              new ListCodec<>(GoalCodecs.goal(), MOST_OTHERS).or(List.of()),
              noted -> Item.of(noted.scenario().challenge().goals()));
  private final Field<Noted, Boolean> inOrder =
      key("in-order", "Whether a goal counts only after those before it.")
          .usual(Scalars.YES_OR_NO.or(false), noted -> noted.scenario().challenge().inOrder());
  private final Field<Noted, Double> timeLimit =
      key("time-limit", "Seconds from the first takeoff on.")
          .optional(
              NumberCodec.seconds(1, Challenge.LONGEST),
              noted -> boxed(noted.scenario().challenge().timeLimit()));
  private final Field<Noted, Boolean> untouched =
      key(
              "touch",
              "Whether a drone that touches anything in flight has failed. A crash always"
                  + " fails.")
          .usual(
              new WordCodec<>(Map.of("forbidden", true, "allowed", false)).or(false),
              noted -> noted.scenario().challenge().untouched());

  private ScenarioCodec() {
    super(
        "scenario",
        Phrase.of("a scenario"),
        "A room, what is in it, which drones fly there, and what they shall do. Lengths in cm,"
            + " angles in degrees, speeds in cm/s.");
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

  /** The scenario, even if its parts do not go together, which is told to the mistakes. */
  @Override
  public Optional<Noted> read(Node node, Context context) {
    Entries in = entries(node, context.withDrones(drones(node)));
    boolean sound = in.sound();
    checkParts(in);
    return sound ? Optional.of(make(in)) : Optional.empty();
  }

  /** How many drones a file has, before it is read: at least one, and at most as many as can be. */
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

  private void checkParts(Entries in) {
    ScenarioValidator checks =
        new ScenarioValidator(in.find(room).orElse(UNKNOWN), in.diagnostics());
    List<Item<ObstacleCodecs.NotedObstacle>> written = in.find(obstacles).orElse(List.of());
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
    }
  }

  private static List<Item<Obstacle>> named(List<Item<ObstacleCodecs.NotedObstacle>> written) {
    List<String> names = ObstacleCodecs.names(Item.values(written));
    List<Item<Obstacle>> named = new ArrayList<>();
    for (Item<ObstacleCodecs.NotedObstacle> item : written) {
      named.add(item.with(item.value().obstacle().named(names.get(named.size()))));
    }
    return named;
  }

  /** The drones of a file, or else the usual one, which is where the file begins. */
  private List<Item<DroneCodec.StationedDrone>> flying(Entries in) {
    List<Item<DroneCodec.StationedDrone>> written = in.find(drones).orElse(List.of());
    return written.isEmpty() && in.sound(drones)
        ? List.of(new Item<>(USUAL_DRONE, 1, Diagnostics.place(in.node())))
        : written;
  }

  private Noted make(Entries in) {
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
    List<DroneCodec.StationedDrone> flying = Item.values(flying(in));
    SimConfig config =
        new SimConfig(
            arena,
            flying.stream().map(DroneCodec.StationedDrone::setup).toList(),
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
            in.get(untouched));
    Scenario scenario =
        new Scenario(
            new Description(
                in.find(name).orElse(LocalizedText.NONE),
                in.find(teaches).orElse(LocalizedText.NONE),
                in.find(difficulty)),
            config,
            flying.stream().map(DroneCodec.StationedDrone::station).toList(),
            challenge);
    return new Noted(
        scenario, in.get(obstacles).stream().map(item -> item.value().notation()).toList());
  }

  /** The JSON schema with which editors check scenario files. */
  Map<String, Object> jsonSchema() {
    Map<String, Object> definitions = new LinkedHashMap<>();
    Map<String, Object> schema =
        Codec.object(
            "$schema",
            "https://json-schema.org/draft/2020-12/schema",
            "title",
            "Scenario of the Tello Simulator");
    schema.putAll(definition(definitions));
    schema.put("$defs", definitions);
    return schema;
  }

  /** A number, or {@code max}. */
  private record TimeFactorCodec() implements Codec<TimeFactor> {

    private static final String MAX = "max";

    private static final NumberCodec NUMBER =
        NumberCodec.of(
            Phrase.of(
                "a time factor from %s to %s, or max",
                NumberCodec.plain(TimeFactor.SMALLEST), NumberCodec.plain(TimeFactor.LARGEST)),
            TimeFactor.SMALLEST,
            TimeFactor.LARGEST);

    @Override
    public Optional<TimeFactor> read(Node node, Context context) {
      return node instanceof ScalarNode scalar && scalar.getValue().equals(MAX)
          ? Optional.of(TimeFactor.MAX)
          : NUMBER.read(node, context).map(TimeFactor::new);
    }

    @Override
    public Node write(TimeFactor factor, Path folder) {
      return factor.unlimited() ? Yaml.text(MAX) : NUMBER.write(factor.value(), folder);
    }

    @Override
    public Map<String, Object> schema(Map<String, Object> definitions) {
      return Codec.object("anyOf", List.of(Codec.object("const", MAX), NUMBER.schema(definitions)));
    }
  }
}
