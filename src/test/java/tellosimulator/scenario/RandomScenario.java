package tellosimulator.scenario;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.SplittableRandom;
import tellosimulator.fault.Fault;
import tellosimulator.fault.FaultPlan;
import tellosimulator.fault.LinkPreset;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.Goal.Direction;
import tellosimulator.goal.GoalRegion;
import tellosimulator.goal.Infraction;
import tellosimulator.goal.Scoring;
import tellosimulator.goal.Terms;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.scenario.Scenario.CommandAddress;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.ObstacleAppearance.Pattern;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;
import tellosimulator.world.Surface;
import tellosimulator.world.Walls;
import tellosimulator.world.Wind;

/** Generates valid scenarios, with numbers of up to three decimals. */
final class RandomScenario {

  private static final List<String> NAMES =
      List.of("table", "yes", "5", "null", "a: b", "- x", "it's", "\"q\"", "#1", "Tür", "🚪", "~");

  private static final List<String> FAULTS =
      List.of(
          "loss state 12.5% burst 3 for 10s",
          "cut drone 1 after 2nd \"forward 100\"",
          "delay replies 44ms spread 38.6ms at 1.5s",
          "stray-binary",
          "loss after \"# a: b\"");

  private final SplittableRandom random;

  RandomScenario(SplittableRandom random) {
    this.random = random;
  }

  Scenario next() {
    Room room = new Room(cm(3000, 20000), cm(3000, 20000), cm(500, 2000));
    List<Obstacle> obstacles = new ArrayList<>();
    for (int i = random.nextInt(6); i > 0; i--) {
      obstacles.add(obstacle(NAMES.get(i) + (random.nextBoolean() ? "" : " " + i)));
    }
    List<MissionPad> pads = new ArrayList<>();
    for (int id = 1 + random.nextInt(8); id <= MissionPad.LAST_ID; id += 1 + random.nextInt(3)) {
      pads.add(
          random.nextBoolean()
              ? MissionPad.onFloor(id, place(), angle())
              : new MissionPad(id, Surface.LEFT_WALL, cm(-900, 900), cm(50, 400), angle()));
    }
    Arena arena =
        new Arena(
            room,
            new Decor(
                cm(10, 200),
                random.nextBoolean() ? Walls.PLAIN : Walls.TEXTURED,
                random.nextBoolean()
                    ? OptionalInt.empty()
                    : OptionalInt.of(random.nextInt(0x1000000)),
                List.of()),
            obstacles,
            pads,
            wind());
    List<DroneSetup> drones = new ArrayList<>();
    List<CommandAddress> stations = new ArrayList<>();
    for (int i = 1 + random.nextInt(4); i > 0; i--) {
      drones.add(drone(new Vec3(cm(1100, 1400), cm(i * 100, i * 100 + 50), 0)));
      stations.add(station(i));
    }
    SimConfig config =
        new SimConfig(
            arena,
            drones,
            random.nextBoolean() ? TimeFactor.MAX : new TimeFactor(number(1, 100)),
            random.nextLong() / 100,
            SimConfig.Rules.DEFAULT
                .withCrashSpeed(random.nextBoolean() ? DroneSpec.CRASH_SPEED : cm(0, 2000))
                .withFaults(faults()));
    return new Scenario(
        new Description(
            text(),
            text(),
            random.nextBoolean()
                ? Optional.empty()
                : Optional.of(pick(List.of(Difficulty.values())))),
        config,
        stations,
        challenge(arena, drones.size()));
  }

  private LocalizedText text() {
    return switch (random.nextInt(3)) {
      case 0 -> LocalizedText.NONE;
      case 1 -> LocalizedText.of(pick(NAMES));
      default -> new LocalizedText(Map.of("en", pick(NAMES), "no", pick(NAMES)));
    };
  }

  private Obstacle obstacle(String name) {
    double thickness = cm(0.1, 10);
    Shape shape =
        switch (random.nextInt(4)) {
          case 0 -> new Shape.Box(cm(1, 100), cm(1, 100), cm(1, 100));
          case 1 -> new Shape.Cylinder(cm(1, 100), cm(1, 100));
          case 2 -> new Shape.Ring(cm(40, 100) / 2, thickness, cm(101, 200));
          default -> new Shape.Frame(cm(40, 100), cm(40, 100), thickness, cm(101, 200));
        };
    ObstacleAppearance appearance =
        new ObstacleAppearance(random.nextInt(1 << 24), pick(List.of(Pattern.values())), Map.of());
    return new Obstacle(name, shape, place().withZ(cm(0, 100)), angle(), appearance);
  }

  private DroneSetup drone(Vec3 start) {
    return new DroneSetup(
        new Pose(start, Attitude.ofHeading(angle())),
        new Product(pick(List.of(Profile.values())), pick(List.of(Behavior.values()))),
        new StreamPorts(1 + random.nextInt(65535), 1 + random.nextInt(65535)),
        number(0, 100),
        random.nextBoolean() ? OptionalInt.empty() : OptionalInt.of(random.nextInt(1 << 24)));
  }

  private CommandAddress station(int number) {
    try {
      byte[] address = {10, 0, 0, (byte) number};
      return new CommandAddress(
          random.nextBoolean() ? Optional.empty() : Optional.of(InetAddress.getByAddress(address)),
          random.nextBoolean() ? OptionalInt.empty() : OptionalInt.of(1 + random.nextInt(65535)));
    } catch (UnknownHostException e) {
      throw new AssertionError(e);
    }
  }

  private FaultPlan faults() {
    List<Fault> faults = new ArrayList<>();
    for (int i = random.nextInt(4); i > 0; i--) {
      faults.add(Fault.of(pick(FAULTS)));
    }
    return new FaultPlan(
        random.nextBoolean() ? Optional.empty() : Optional.of(pick(List.of(LinkPreset.values()))),
        faults);
  }

  private Wind wind() {
    if (random.nextBoolean()) {
      return Wind.CALM;
    }
    double heading = angle();
    double speed = cm(1, 1000);
    return new Wind(
        new Vec3(StrictMath.cos(heading) * speed, StrictMath.sin(heading) * speed, 0), cm(0, 500));
  }

  private Challenge challenge(Arena arena, int drones) {
    List<Goal> goals = new ArrayList<>();
    for (Obstacle obstacle : arena.obstacles()) {
      if (obstacle.shape() instanceof Shape.Gate) {
        goals.add(new Goal.Pass(terms(drones), obstacle.name(), pick(List.of(Direction.values()))));
      }
    }
    for (MissionPad pad : arena.pads()) {
      if (pad.surface() == Surface.FLOOR) {
        goals.add(
            new Goal.See(
                terms(drones), new Goal.NumberedPad(pad.id()), number(1, 60), number(1, 9)));
        goals.add(new Goal.LandOn(terms(drones), pad.id()));
      }
    }
    goals.add(new Goal.Reach(terms(drones), new GoalRegion(place().withZ(cm(0, 400)), cm(1, 100))));
    goals.add(
        new Goal.Hover(
            terms(drones), new GoalRegion(place().withZ(cm(0, 400)), cm(1, 100)), number(1, 100)));
    goals.add(new Goal.Land(terms(drones), new GoalRegion(place(), cm(1, 100))));
    return new Challenge(
        random.nextBoolean() ? goals : List.of(),
        random.nextBoolean(),
        random.nextBoolean() ? OptionalDouble.empty() : OptionalDouble.of(number(1, 1000)),
        random.nextBoolean(),
        random.nextBoolean() ? Optional.empty() : Optional.of(scoring()));
  }

  private Scoring scoring() {
    Map<Infraction, Double> penalties = new EnumMap<>(Infraction.class);
    for (Infraction infraction : Infraction.values()) {
      if (random.nextBoolean()) {
        penalties.put(infraction, number(0, 100));
      }
    }
    return new Scoring(
        penalties,
        random.nextBoolean()
            ? Optional.empty()
            : Optional.of(new Scoring.Par(number(1, 1000), number(0, 10))),
        random.nextBoolean()
            ? Optional.empty()
            : Optional.of(new Scoring.Bonus(number(0, 100), number(0, 100), number(200, 300))),
        random.nextBoolean()
            ? Scoring.Limits.DEFAULT
            : new Scoring.Limits(number(-100, 0), number(1, 100)));
  }

  private Terms terms(int drones) {
    Terms terms = random.nextBoolean() ? Terms.ANY : Terms.of(1 + random.nextInt(drones));
    return random.nextBoolean() ? terms : terms.worth(number(0, 100));
  }

  private Vec3 place() {
    return new Vec3(cm(-1000, 1000), cm(-1000, 1000), 0);
  }

  /** Returns a length as in a file, in metres. */
  private double cm(double least, double most) {
    return number(least, most) / 100;
  }

  private double angle() {
    return StrictMath.toRadians(number(-179, 180));
  }

  private double number(double least, double most) {
    return Math.round((least + random.nextDouble() * (most - least)) * 1000) / 1000.0;
  }

  private <T> T pick(List<T> values) {
    return values.get(random.nextInt(values.size()));
  }
}
