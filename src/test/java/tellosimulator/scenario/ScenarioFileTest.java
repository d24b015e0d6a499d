package tellosimulator.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.files.IrregularFileException;
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
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.testing.ForPeople;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.ObstacleAppearance.Pattern;
import tellosimulator.world.ObstacleAppearance.Side;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;
import tellosimulator.world.Surface;
import tellosimulator.world.Walls;
import tellosimulator.world.Wind;

class ScenarioFileTest {

  private static final String EVERYTHING =
      """
      name: Everything
      teaches: {en: what a file can say, de: was in einer Datei stehen kann}
      difficulty: medium
      room: {width: 800, depth: 600, height: 250}
      grid: 50
      walls: plain
      accent: "#c9b18a"
      posters:
        - {wall: left, along: -20, height: 120, width: 30, picture: face.png}
      obstacles:
        - box:
            name: table
            at: [100, 50]
            base: 70
            size: [80, 120, 5]
            heading: 30
            colour: brown
            pattern: stripes
            pictures: {top: face.png, left: face.png}
        - cylinder: {at: [-100, 0], radius: 10, height: 250, colour: "#102030"}
        - wall: {from: [0, -300], to: [0, -100], height: 150, thickness: 8}
        - gate: {name: ring, at: [200, 0], shape: ring, diameter: 80, centre: 120}
        - gate: {at: [200, 200], shape: frame, width: 90, height: 70, centre: 100,
                 thickness: 4, heading: 90}
      pads:
        - {id: 3, at: [150, -120], heading: 45}
        - {id: 8, wall: back, along: 50, height: 120, rotation: -90}
      drones:
        - {start: [-200, 0], heading: 90, profile: tt, behaviour: measured, colour: red,
           battery: 55.5, address: 127.0.0.7, command-port: 8889, state-port: 9001,
           video-port: 9002}
        - {start: [-200, 100]}
      wind: {towards: 90, speed: 150, gusts: 40}
      crash-speed: 80
      time-factor: 2.5
      seed: -17
      goals:
        - pass: {gate: ring, direction: along, drone: 2}
        - reach: {at: [0, 0, 150], radius: 25}
        - hover: {at: [10, 0, 150], seconds: 5}
        - land-on: {pad: 3, points: 2.5}
        - land: {at: [-200, 0], drone: 1}
      in-order: true
      time-limit: 90
      touch: forbidden
      scoring: {touch: 5, crash: 20, refused: 0.5, not-landed: 10, par: 60, each-second: 0.25,
                bonus: {points: 10, full-until: 40, none-from: 80}, least: -5, most: 100}
      """;

  @TempDir private Path folder;

  @BeforeEach
  void picture() throws IOException {
    Files.createFile(folder.resolve("face.png"));
  }

  @Test
  void everythingThatAFileCanSayIsRead() throws Exception {
    Scenario scenario = read(EVERYTHING);

    Description description = scenario.description();
    assertThat(description.name()).isEqualTo(LocalizedText.of("Everything"));
    assertThat(description.teaches().in(Locale.ENGLISH)).isEqualTo("what a file can say");
    assertThat(description.teaches().in(Locale.GERMAN)).isEqualTo("was in einer Datei stehen kann");
    assertThat(description.difficulty()).contains(Difficulty.MEDIUM);
    SimConfig config = scenario.config();
    assertThat(config.timeFactor()).isEqualTo(new TimeFactor(2.5));
    assertThat(config.seed()).isEqualTo(-17);
    Arena arena = config.arena();
    assertThat(arena.room()).isEqualTo(new Room(8, 6, 2.5));
    String picture = folder.resolve("face.png").toString();
    assertThat(arena.decor())
        .isEqualTo(
            new Decor(
                0.5,
                Walls.PLAIN,
                OptionalInt.of(0xc9b18a),
                List.of(new Poster(Surface.LEFT_WALL, -0.2, 1.2, 0.3, picture))));
    assertThat(arena.wind().mean().distanceTo(new Vec3(0, 1.5, 0))).isLessThan(1e-9);
    assertThat(arena.wind().gusts()).isEqualTo(0.4);
    assertThat(scenario.config().rules().crashSpeed()).isEqualTo(0.8);
    assertThat(arena.pads())
        .containsExactly(
            MissionPad.onFloor(3, new Vec3(1.5, -1.2, 0), Math.PI / 4),
            new MissionPad(8, Surface.BACK_WALL, 0.5, 1.2, -Math.PI / 2));
    assertThat(scenario.challenge())
        .isEqualTo(
            new Challenge(
                List.of(
                    new Goal.Pass(Terms.of(2), "ring", Direction.ALONG),
                    new Goal.Reach(Terms.ANY, new GoalRegion(new Vec3(0, 0, 1.5), 0.25)),
                    new Goal.Hover(Terms.ANY, new GoalRegion(new Vec3(0.1, 0, 1.5), 0.3), 5),
                    new Goal.LandOn(Terms.ANY.worth(2.5), 3),
                    new Goal.Land(Terms.of(1), new GoalRegion(new Vec3(-2, 0, 0), 0.3))),
                true,
                OptionalDouble.of(90),
                true,
                Optional.of(
                    new Scoring(
                        Map.of(
                            Infraction.TOUCH, 5.0,
                            Infraction.CRASH, 20.0,
                            Infraction.REFUSED, 0.5,
                            Infraction.NOT_LANDED, 10.0),
                        Optional.of(new Scoring.Par(60, 0.25)),
                        Optional.of(new Scoring.Bonus(10, 40, 80)),
                        new Scoring.Limits(-5, 100)))));
  }

  @Test
  void postersAndPadsToSeeAreReadAndKeptWhenSaved() throws Exception {
    String text =
        """
        posters:
          - {wall: left, height: 120, width: 30, picture: face.png}  # one
          - {wall: right, height: 120, width: 30, picture: face.png, name: twin}
        pads: [{id: 3, wall: front, height: 100}]
        goals:
          - see: {poster: face, drone: 1}   # the first one
          - see: {poster: twin, size: 22.5, seconds: 3}
          - see: {pad: 3}
        """;
    Path file = Files.writeString(folder.resolve("search.yaml"), text);
    ScenarioDocument opened = ScenarioFile.open(file);
    Challenge read = opened.scenario().challenge();
    assertThat(read.goals())
        .containsExactly(
            new Goal.See(Terms.of(1), new Goal.NamedPoster("face"), 10, 1),
            new Goal.See(Terms.ANY, new Goal.NamedPoster("twin"), 22.5, 3),
            new Goal.See(Terms.ANY, new Goal.NumberedPad(3), 10, 1));

    Goal.See second = (Goal.See) read.goals().get(1);
    Goal other = second.of(new Goal.NumberedPad(3));
    Challenge changed = read.withGoals(List.of(read.goals().get(0), other, read.goals().get(2)));
    ScenarioDocument saved = opened.changedTo(opened.scenario().withChallenge(changed), folder);

    assertThat(new String(saved.bytes().orElseThrow(), StandardCharsets.UTF_8))
        .isEqualTo(text.replace("poster: twin, size", "pad: 3, size"));
  }

  @Test
  void obstaclesAreRead() throws Exception {
    String picture = folder.resolve("face.png").toString();

    assertThat(read(EVERYTHING).config().arena().obstacles())
        .containsExactly(
            new Obstacle(
                "table",
                new Shape.Box(0.8, 1.2, 0.05),
                new Vec3(1, 0.5, 0.7),
                StrictMath.toRadians(30),
                new ObstacleAppearance(
                    0x8a5a36, Pattern.STRIPES, Map.of(Side.TOP, picture, Side.LEFT, picture))),
            new Obstacle(
                "cylinder 1",
                new Shape.Cylinder(0.1, 2.5),
                new Vec3(-1, 0, 0),
                0,
                new ObstacleAppearance(0x102030, Pattern.PLAIN, Map.of())),
            // the wall leads towards +y, so its front, on the right, faces +x
            new Obstacle(
                "wall 1",
                new Shape.Box(0.08, 2, 1.5),
                new Vec3(0, -2, 0),
                0,
                ObstacleAppearance.DEFAULT),
            new Obstacle(
                "ring",
                new Shape.Ring(0.4, 0.05, 1.2),
                new Vec3(2, 0, 0),
                0,
                ObstacleAppearance.DEFAULT),
            new Obstacle(
                "gate 1",
                new Shape.Frame(0.9, 0.7, 0.04, 1),
                new Vec3(2, 2, 0),
                StrictMath.toRadians(90),
                ObstacleAppearance.DEFAULT));
  }

  @Test
  void dronesAreReadAndListenWhereTheFileSays() throws Exception {
    Scenario scenario = read(EVERYTHING);

    assertThat(scenario.config().drones())
        .containsExactly(
            new DroneSetup(
                new Pose(new Vec3(-2, 0, 0), Attitude.ofHeading(StrictMath.toRadians(90))),
                new Product(Profile.TT, Behavior.MEASURED),
                new StreamPorts(9001, 9002),
                55.5,
                OptionalInt.of(0xc0392b)),
            DroneSetup.at(
                new Pose(new Vec3(-2, 1, 0), Attitude.LEVEL),
                Product.DEFAULT,
                StreamPorts.DEFAULT));
    assertThat(scenario.addressPlan(8879).drones())
        .extracting(drone -> drone.addresses().get(0) + ":" + drone.port())
        .containsExactly("/127.0.0.7:8889", "/127.0.0.2:8879");
  }

  @Test
  void whatIsNotSaidIsAsUsual() throws Exception {
    assertThat(read("name: Nothing else").config()).isEqualTo(SimConfig.DEFAULT);
    assertThat(read("{}")).isEqualTo(Scenario.of(SimConfig.DEFAULT));
  }

  @Test
  void unnamedObstaclesGetNamesThatNoOtherHas() throws Exception {
    Scenario scenario =
        read(
            """
            obstacles:
              - box: {at: [100, 0], size: [10, 10, 10]}
              - box: {name: box 1, at: [130, 0], size: [10, 10, 10]}
              - box: {at: [160, 0], size: [10, 10, 10]}
            """);
    assertThat(scenario.config().arena().obstacles())
        .extracting(Obstacle::name)
        .containsExactly("box 2", "box 1", "box 3");
  }

  @Test
  void everythingComesBackAsItWasWritten() throws Exception {
    Scenario scenario = read(EVERYTHING);

    assertThat(rewritten(scenario)).isEqualTo(scenario);
  }

  @Test
  void whateverIsWrittenComesBack() throws Exception {
    SplittableRandom random = new SplittableRandom(7);
    for (int i = 0; i < 200; i++) {
      Scenario scenario = new RandomScenario(random).next();
      assertThat(rewritten(scenario)).as("scenario %d", i).isEqualTo(scenario);
    }
  }

  @Test
  void aWrittenFileIsEasyToRead() throws Exception {
    ScenarioFile.write(read(EVERYTHING), folder.resolve("out.yaml"));

    assertThat(Files.readString(folder.resolve("out.yaml")))
        .startsWith(
            """
            name: Everything

            teaches: {en: what a file can say, de: was in einer Datei stehen kann}
            difficulty: medium

            room: {width: 800, depth: 600, height: 250}
            grid: 50
            walls: plain
            accent: "#c9b18a"

            posters:
              - {wall: left, along: -20, height: 120, width: 30, picture: face.png}

            obstacles:
              - box: {name: table, at: [100, 50], base: 70, size: [80, 120, 5], heading: 30, \
            """)
        .doesNotContain("\t");
  }

  @Test
  void aThousandObstaclesAreReadWithinHalfASecond(TestReporter reporter) throws Exception {
    StringBuilder text = new StringBuilder("room: {width: 20000, depth: 20000}\nobstacles:\n");
    for (int i = 0; i < 1000; i++) {
      text.append("  - box: {at: [")
          .append(200 + i % 40 * 150)
          .append(", ")
          .append(i / 40 * 150)
          .append("], size: [50, 60.5, 120], heading: 30, colour: blue}\n");
    }
    Path file = folder.resolve("thousand.yaml");
    Files.writeString(file, text);
    ThreadMXBean processor = ManagementFactory.getThreadMXBean(); // others may use it, too
    long fastest = Long.MAX_VALUE;
    for (int i = 0; i < 5; i++) {
      long begin = processor.getCurrentThreadCpuTime();
      assertThat(ScenarioFile.read(file).config().arena().obstacles()).hasSize(1000);
      fastest = Math.min(fastest, processor.getCurrentThreadCpuTime() - begin);
    }
    reporter.publishEntry("a thousand obstacles", fastest / 1_000_000 + " ms");
    assertThat(fastest / 1_000_000).as("ms of a processor").isLessThan(500);
  }

  // --- mistakes ---

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      textBlock =
          """
          room: {width: abc}                  | 1:15: expected a length in cm from 100 to 20000, found "abc"
          room: {width: -500}                 | 1:15: expected a length in cm from 100 to 20000, found "-500"
          room: {width: .nan}                 | 1:15: expected a length in cm from 100 to 20000, found ".nan"
          room: {width: .inf}                 | 1:15: expected a length in cm from 100 to 20000, found ".inf"
          room: {width: 1e999}                | 1:15: expected a length in cm from 100 to 20000, found "1e999"
          room: {width: 1e}                   | 1:15: expected a length in cm from 100 to 20000, found "1e"
          room: {width: 1.2.3}                | 1:15: expected a length in cm from 100 to 20000, found "1.2.3"
          room: {width: 200-300}              | 1:15: expected a length in cm from 100 to 20000, found "200-300"
          room: {width: 0x100}                | 1:15: expected a length in cm from 100 to 20000, found "0x100"
          room: {width: 300f}                 | 1:15: expected a length in cm from 100 to 20000, found "300f"
          room: {width: NaN}                  | 1:15: expected a length in cm from 100 to 20000, found "NaN"
          room: {width: true}                 | 1:15: expected a length in cm from 100 to 20000, found "true"
          room: {width: "500"}                | 1:15: expected a length in cm from 100 to 20000, found "500"
          room: {width: [500]}                | 1:15: expected a length in cm from 100 to 20000, found a list of 1
          room: {width: }                     | 1:14: expected a length in cm from 100 to 20000, found nothing
          room: 5                             | 1:7: expected a room, found "5"
          rom: {width: 500}                   | 1:1: a scenario has no key "rom", did you mean room?
          time_limit: 5                       | 1:1: a scenario has no key "time_limit", did you mean time-limit?
          zebra: 5                            | 1:1: a scenario has no key "zebra", but only name, teaches, difficulty, room, grid, walls, accent, posters, obstacles, pads, drones, wind, link, faults, crash-speed, time-factor, seed, goals, in-order, time-limit, touch, scoring
          name: {}                            | 1:7: expected a text in at least one language, found none
          name: {english: a}                  | 1:8: expected a language such as en or de, found "english"
          name: {[de]: a}                     | 1:8: expected a language such as en or de, found a list of 1
          name: {en: a, en: b}                | 1:15: the key en is there twice
          name: {en: a, de: 5}                | 1:19: expected a line of text of at most 200 letters, found "5"
          name: {de: {en: a}}                 | 1:12: expected a line of text of at most 200 letters, found a mapping
          name: [a]                           | 1:7: expected a line of text of at most 200 letters, found a list of 1
          difficulty: harder                  | 1:13: expected one of easy, hard, medium, found "harder"
          {name: a, name: b}                  | 1:11: the key name is there twice
          [1, 2]                              | 1:1: expected a scenario, found a list of 2
          just words                          | 1:1: expected a scenario, found "just words"
          walls: papered                      | 1:8: expected one of auto, plain, textured, found "papered"
          walls: plane                        | 1:8: expected one of auto, plain, textured, found "plane", did you mean plain?
          drones: {start: [0, 0]}             | 1:9: expected a list, found a mapping
          drones: [{}]                        | 1:10: a drone needs the key start
          drones: [{start: 5}]                | 1:18: expected [x, y] in cm, each from -20000 to 20000, found "5"
          drones: [{start: [0, 0, 0]}]        | 1:18: expected [x, y] in cm, each from -20000 to 20000, found a list of 3
          drones: [{start: [9999, 0]}]        | 1:10: drone 1 does not fit into the room there
          drones: [{start: [0, 0]}, {start: [10, 0]}] | 1:27: drone 2 is in drone 1
          drones: [{start: [0, 0], battery: 101}] | 1:35: expected a percentage from 0 to 100, found "101"
          drones: [{start: [0, 0], colour: rainbow}] | 1:34: expected a colour such as "#d9772b", or one of black, blue, brown, green, grey, orange, purple, red, white, yellow, found "rainbow"
          drones: [{start: [0, 0], address: 127.0.0.300}] | 1:35: expected an address of this machine such as 127.0.0.2, found "127.0.0.300"
          drones: [{start: [0, 0], address: 239.1.2.3}] | 1:35: expected an address of this machine such as 127.0.0.2, found "239.1.2.3"
          drones: [{start: [0, 0], command-port: 0}] | 1:40: expected a port from 1 to 65535, found "0"
          drones: [{start: [0, 0]}, {start: [0, 50], address: 127.0.0.1}] | 1:27: drone 2 takes commands where drone 1 does
          drones: [5]                         | 1:10: expected a drone, found "5"
          drones: [{start: [0, 0]}, {start: abc}] | 1:35: expected [x, y] in cm, each from -20000 to 20000, found "abc"
          {room: {width: 2O00}, pads: [{id: 1, at: [0, 600]}], drones: [{start: [0, 700]}]} | 1:16: expected a length in cm from 100 to 20000, found "2O00"
          pads: [{id: 9, at: [0, 0]}]         | 1:13: expected a pad from 1 to 8, found "9"
          pads: [{id: 1, at: [0, 0]}, {id: 1, at: [50, 0]}] | 1:29: there are two mission pads of the number 1
          pads: [{id: 1, at: [245, 0]}]       | 1:8: the mission pad 1 is not on the floor
          pads: [{id: 1, wall: left, height: 295}] | 1:8: the mission pad 1 is not on the left wall
          pads: [{id: 1, wall: left, height: 100, at: [0, 0]}] | 1:45: the key at does not go with wall
          pads: [{id: 1, at: [0, 0], rotation: 5}] | 1:38: the key rotation goes only with wall
          obstacles: [{}]                     | 1:13: expected one of box, cylinder, wall, gate, found 0 of them
          obstacles: [{bx: {}}]               | 1:14: an obstacle has no key "bx", did you mean box?
          obstacles: [{box: {at: [0, 0], size: [0, 1, 1]}}] | 1:39: expected a length in cm from 0.1 to 20000, found "0"
          obstacles: [{box: {at: [240, 0], size: [40, 40, 40]}}] | 1:13: the obstacle "box 1" is not in the room
          obstacles: [{cylinder: {at: [99, 0], radius: 5, height: 301}}] | 1:13: the obstacle "cylinder 1" is not in the room
          obstacles: [{wall: {from: [0, 0], to: [0, 0], height: 5}}] | 1:39: expected another place than that of from
          obstacles: [{gate: {at: [0, 0], shape: ring, diameter: 80, centre: 20}}] | 1:68: the centre of this opening must be at least 45 cm high
          obstacles: [{gate: {at: [0, 0], shape: ring, diameter: 80, centre: 90, width: 5}}] | 1:79: the key width does not go with ring
          obstacles: [{gate: {at: [0, 0], shape: ring, diameter: 0.1, centre: 90}}] | 1:56: expected a length in cm from 0.2 to 20000, found "0.1"
          {room: {width: 20000, depth: 20000}, obstacles: [{wall: {from: [-9000, -9000], to: [9000, 9000], height: 5}}]} | 1:84: expected a wall of at most 20000 cm
          posters: [{wall: front, height: 100, width: 30, picture: none.png}] | 1:58: expected the name of an image file, found no file "none.png"
          wind: {speed: 5000}                 | 1:15: expected a speed in cm/s from 0 to 2000, found "5000"
          crash-speed: -5                     | 1:14: expected a speed in cm/s from 0 to 2000, found "-5"
          crash_sped: 80                      | 1:1: a scenario has no key "crash_sped", did you mean crash-speed?
          wind: {towards: 400}                | 1:17: expected an angle in degrees from -360 to 360, found "400"
          time-factor: fast                   | 1:14: expected a time factor from 0.01 to 5000, or max, found "fast"
          seed: 1.5                           | 1:7: expected a whole number of at most 18 digits, found "1.5"
          goals: [{land-on: {pad: 3}}]        | 1:9: no mission pad 3 lies on the floor
          {goals: [{land-on: {pad: 3}}], pads: [{id: 3, at: 5}]} | 1:51: expected [x, y] in cm, each from -20000 to 20000, found "5"
          goals: [{reach: {at: [0, 0, 301]}}] | 1:9: this place is not in the room
          goals: [{reach: {at: [0, 0, 30], drone: 2}}] | 1:41: expected drone 1, the only one, found "2"
          goals: [{reach: {at: [0, 0, 30], points: -1}}] | 1:42: expected points from 0 to 1000, found "-1"
          scoring: {touch: 1001}              | 1:18: expected points from 0 to 1000, found "1001"
          scoring: {par: 60}                  | 1:10: scoring needs the key each-second
          scoring: {each-second: 1}           | 1:24: the key each-second goes only with par
          scoring: {bonus: {points: 5, full-until: 80, none-from: 40}} | 1:57: none-from must be later than full-until
          scoring: {least: 50, most: 20}      | 1:28: most is less than least
          goals: [{hover: {at: [0, 0, 30]}}]  | 1:17: a place to hover needs the key seconds
          goals: [{pass: {gate: ring}}]       | 1:9: there is no gate "ring"
          goals: [{see: {pad: 3}}]            | 1:9: there is no mission pad 3
          goals: [{see: {poster: cat}}]       | 1:9: there is no poster "cat"
          goals: [{see: {size: 20}}]          | 1:15: a poster or pad to see needs the key pad
          goals: [{see: {poster: cat, pad: 1}}] | 1:34: the key pad does not go with poster
          goals: [{see: {poster: cat, size: 61}}] | 1:35: expected percent from 1 to 60, found "61"
          goals: [{see: {poster: cat, seconds: 0}}] | 1:38: expected seconds from 0.1 to 3600, found "0"
          {posters: [{wall: left, height: 100, width: 30, picture: face.png}], goals: [{see: {poster: fase}}]} | 1:78: there is no poster "fase", did you mean face?
          {posters: [&p {wall: left, height: 100, width: 30, picture: face.png}, *p], goals: [{see: {poster: face}}]} | 1:85: there are 2 posters of the name face: name one of them
          in-order: yes                       | 1:11: expected one of false, true, found "yes"
          touch: never                        | 1:8: expected one of allowed, forbidden, found "never"
          name: true                          | 1:7: expected a line of text of at most 200 letters, found "true"
          name: 1.5e3                         | 1:7: expected a line of text of at most 200 letters, found "1.5e3"
          name: 5                             | 1:7: expected a line of text of at most 200 letters, found "5"
          name: "a: b                         | 2:1: this is not YAML: found unexpected end of stream
          name: a: b                          | 1:8: this is not YAML: mapping values are not allowed here; text with a colon or a sign such as @ needs quotes, as in name: "Slalom: the race"
          name: @b                            | 1:7: this is not YAML: found character '@' that cannot start any token; text with a colon or a sign such as @ needs quotes, as in name: "Slalom: the race"
          time-limit: 90 km                   | 1:13: expected seconds from 1 to 86400, found "90 km"
          time-limit: 0.5s                    | 1:13: expected seconds from 1 to 86400, found "0.5s"
          {obstacles: [{box: {name: crate, at: [100, 0], size: [100, 100, 100]}}], goals: [{reach: {at: [100, 0, 50]}}]} | 1:82: no drone can reach this place: it is in the obstacle "crate"
          {obstacles: [{wall: {name: w, from: [50, -100], to: [50, 100], height: 200}}], goals: [{hover: {at: [50, 0, 100], radius: 2, seconds: 3s}}]} | 1:88: no drone can reach this place: it is in the obstacle "w"
          {obstacles: [{box: {name: crate, at: [100, 0], size: [100, 100, 100]}}], pads: [{id: 3, at: [100, 0]}], goals: [{land-on: {pad: 3}}]} | 1:113: no drone can reach this place: it is in the obstacle "crate"
          room: *hall                         | 1:7: this is not YAML: found undefined alias hall
          ? [a, b]                            | 1:3: expected a key, found a list of 2
          """)
  void aMistakeIsOneSentenceWithItsPlace(String text, String sentence) {
    assertThat(diagnostics(text + "\n")).containsExactly(sentence);
  }

  @Test
  void theFastestWindCanBlowAnywhere() throws Exception {
    for (int towards = -360; towards <= 360; towards++) {
      Wind wind = read("wind: {speed: 2000, towards: " + towards + "}\n").config().arena().wind();
      assertThat(wind.mean().norm()).isCloseTo(20, within(1e-9));
    }
  }

  @Test
  void aGateIsGuessedAt() {
    String text =
        """
        obstacles:
          - gate: {name: first, at: [100, 0], shape: ring, diameter: 80, centre: 120}
          - box: {name: table, at: [0, 100], size: [50, 50, 50]}
        goals:
          - pass: {gate: frist}
          - pass: {gate: table}
        """;
    assertThat(diagnostics(text))
        .containsExactly(
            "5:5: there is no gate \"frist\", did you mean first?",
            "6:5: the obstacle \"table\" is no gate");
  }

  @Test
  void aDroneCanStandUnderATableButNotInIt() throws Exception {
    String table = "obstacles: [{box: {name: table, at: [0, 0], base: 50, size: [80, 80, 5]}}]\n";
    assertThat(read(table).config().drones()).hasSize(1);

    assertThat(diagnostics(table.replace("base: 50", "base: 2")))
        .as("the usual drone")
        .containsExactly("1:1: drone 1 is in the obstacle \"table\"");
    assertThat(diagnostics("# a comment\n" + table.replace("base: 50", "base: 2")))
        .containsExactly("2:1: drone 1 is in the obstacle \"table\"");
    String chest = table.replace("base: 50", "base: 2") + "drones: [{start: [40, 0]}]\n";
    assertThat(diagnostics(chest)).containsExactly("2:10: drone 1 is in the obstacle \"table\"");
  }

  @Test
  void allMistakesAreToldAtOnceInTheOrderOfTheirPlaces() {
    String text =
        """
        goals:
          - reach: {at: [0, 0, 30], radius: -5}
        room: {width: abc, hight: 300}
        obstacles:
          - box: {at: [0, 200], size: 5}
        """;
    assertThat(diagnostics(text))
        .containsExactly(
            "2:37: expected a length in cm from 1 to 20000, found \"-5\"",
            "3:15: expected a length in cm from 100 to 20000, found \"abc\"",
            "3:20: a room has no key \"hight\", did you mean height?",
            "5:31: expected [x, y, z] in cm, each from 0.1 to 20000, found \"5\"");
  }

  @Test
  void tooManyMistakesAreCounted() {
    List<String> found = diagnostics("a: 1\n".repeat(250));

    assertThat(found).hasSize(101);
    assertThat(found.get(100)).isEqualTo("100:1: and 150 more mistakes");
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "\n\n", "# only a comment\n"})
  void anEmptyFileIsASentence(String text) {
    assertThat(diagnostics(text)).containsExactly("1:1: the file is empty");
  }

  @Test
  void aSecondDocumentIsASentence() {
    assertThat(diagnostics("name: a\n---\nname: b\n"))
        .containsExactly("2:1: this is not YAML: but found another document");
  }

  @Test
  void anAliasIsReadAsWhatItStandsFor() throws Exception {
    List<Obstacle> obstacles =
        read("""
                obstacles:
                  - box: &a {at: [0, 90], size: &s [50, 40, 30]}
                  - box: *a
                  - box: {at: [0, -90], size: *s}
                """)
            .config()
            .arena()
            .obstacles();
    assertThat(obstacles).extracting(Obstacle::shape).containsOnly(new Shape.Box(0.5, 0.4, 0.3));
    assertThat(obstacles).extracting(Obstacle::name).containsExactly("box 1", "box 2", "box 3");
  }

  @Test
  void binaryFilesAreASentence() throws IOException {
    byte[] random = new byte[5000];
    new SplittableRandom(3).nextBytes(random);
    assertThat(diagnostics(random)).singleElement().asString().contains("found other bytes");

    assertThat(diagnostics("name: a\nteaches: \u0001b\n".getBytes(StandardCharsets.UTF_8)))
        .containsExactly("2:10: expected text, found the control character 1");
  }

  @Test
  @Timeout(60)
  void theLargestRoomIsRead() throws Exception {
    StringBuilder file = new StringBuilder("room: {depth: 20000, width: 20000}\nobstacles:\n");
    for (int i = 0; i < 10_000; i++) {
      file.append(
          "  - box: {name: n%d, at: [%d, %d], base: 10, heading: 30, "
              .formatted(i, i % 100 * 190 - 9_400, i / 100 * 190 - 9_400));
      file.append("size: [50, 40, 30], colour: \"#aabbcc\"}\n");
    }

    assertThat(read(file.toString()).config().arena().obstacles()).hasSize(10_000);
  }

  @Test
  @Timeout(20)
  void aHugeFileIsASentence() throws IOException {
    byte[] huge = new byte[Source.LARGEST + 1];
    java.util.Arrays.fill(huge, (byte) ' ');
    assertThat(diagnostics(huge))
        .containsExactly("expected a file of at most 4 MB, found a larger one");
  }

  @Test
  @Timeout(20)
  void hostileFilesAreASentence() {
    assertThat(diagnostics("a: " + "[".repeat(1_000_000)))
        .containsExactly("1:23: expected at most 20 levels, found more");
    assertThat(diagnostics("a: [" + "1,".repeat(1_500_000) + "]"))
        .containsExactly("1:40005: expected at most 20000 entries, found more");
    assertThat(diagnostics("a:\n" + ("  - [" + "1,".repeat(15_000) + "]\n").repeat(40)))
        .containsExactly("35:9862: expected at most 500000 values, found more");
    assertThat(diagnostics("&a [*a, *a]"))
        .containsExactly("1:1: expected a scenario, found a list of 2");
    assertThat(diagnostics("room: &a {width: *a}"))
        .containsExactly("1:7: expected a length in cm from 100 to 20000, found a mapping");
    assertThat(diagnostics("obstacles: &a\n  - *a\n"))
        .containsExactly("1:12: expected an obstacle, found a list of 1");
    String bomb =
        "a: &a [1,1,1,1,1,1,1,1,1]\n"
            + IntStream.range(0, 15)
                .mapToObj(
                    i ->
                        "b"
                            + i
                            + ": &"
                            + (char) ('b' + i)
                            + " ["
                            + ("*" + (char) ('a' + i) + " ,").repeat(9)
                            + "]\n")
                .reduce("", String::concat);
    assertThat(diagnostics(bomb))
        .singleElement()
        .asString()
        .matches("\\d+:\\d+: expected at most 50 aliases, found more");
    assertThat(diagnostics("name: a\n? [b]\n: c\n"))
        .containsExactly("2:3: expected a key, found a list of 1");
    assertThat(diagnostics("%YAML 9.9\n---\nname: a\n"))
        .containsExactly("expected YAML 1.2, found 9.9");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      textBlock =
          """
          name: a%nteaches: X         ; x    ; 2:10
          name: a%nteaches: "X"       ; x    ; 2:10
          name: a%nteaches: 'X'       ; x    ; 2:10
          name: a%nteaches: "X"       ; '\\n' ; 2:10
          name: a%nteaches: |%n X     ; x    ; 2:10
          name: a%nteaches: >%n X     ; 'x ' ; 2:10
          name: a%nteaches: X         ; 'x ' ; 2:10
          name: a%nseed: X            ; 1    ; 2:7
          name: a%nX: 1               ; x    ;
          name: a%n? X                ; x    ; 2:3
          name: a%n"X": 1             ; x    ;
          name: a%n# X                ; x    ;
          name: &X a                  ; x    ;
          name: *X                    ; x    ;
          name: !X a                  ; x    ;
          name: a%n"X                 ; '  ' ;
          name: aXb                   ; '  ' ;
          %%YAML 1.X%n---%nname: a    ; 1    ;
          %%X 1%n---%nname: a         ; x    ;
          obstacles: [X]              ; {    ;
          obstacles:%nX               ; '- ' ;
          """)
  @Timeout(60) // 1.5 s on a slow machine; hours if it is not linear
  void whateverIsLongIsReadOrRefusedSoonAndInLittleMemory(String form, String piece, String place)
      throws IOException {
    String full = piece.repeat(4_000_000 / piece.length());
    byte[] text = String.format(form).replace("X", full).getBytes(StandardCharsets.UTF_8);
    Path file = file(text);
    var threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    long allocated = threads.getCurrentThreadAllocatedBytes();

    String refused = "";
    try {
      ScenarioFile.read(file);
    } catch (ScenarioException e) {
      refused = e.getMessage().substring(file.toString().length() + 1);
    }

    long bytes = threads.getCurrentThreadAllocatedBytes() - allocated;
    assertThat(bytes).isLessThan(500_000_000);
    assertThat(refused).hasSizeLessThan(500);
    if (place != null) {
      assertThat(refused).isEqualTo(place + ": expected at most 10000 letters, found more");
    }
  }

  @Test
  @NeedsTool(Tool.MKFIFO)
  @Timeout(20)
  void aPipeAndADeviceAreASentence() throws Exception {
    Path pipe = folder.resolve("pipe.yaml");
    assertThat(Tool.MKFIFO.command(pipe.toString()).start().waitFor()).isZero();
    for (Path file : List.of(pipe, Path.of("/dev/zero"))) {
      assertThat(catchThrowableOfType(ScenarioException.class, () -> ScenarioFile.read(file)))
          .hasMessage(file + ": expected a file, found a pipe or a device");
    }
  }

  /** A pipe replaces the file; writing to it would wait for a reader, or never end. */
  @Test
  @NeedsTool(Tool.MKFIFO)
  @Timeout(20)
  void nothingIsSavedIntoAPipeOrADevice() throws Exception {
    Path pipe = folder.resolve("pipe.yaml");
    assertThat(Tool.MKFIFO.command(pipe.toString()).start().waitFor()).isZero();
    Path device = Files.createSymbolicLink(folder.resolve("link.yaml"), Path.of("/dev/zero"));
    ScenarioDocument document = ScenarioDocument.of(Scenario.of(SimConfig.DEFAULT));
    for (Path file : List.of(pipe, device)) {
      assertThatThrownBy(() -> ScenarioFile.holds(file, document))
          .isInstanceOf(IrregularFileException.class);
      assertThatThrownBy(() -> ScenarioFile.write(document, file))
          .isInstanceOf(IrregularFileException.class);
    }
  }

  @Test
  void whatCannotBeReadIsASentence() {
    Path missing = folder.resolve("missing.yaml");
    assertThat(catchThrowableOfType(ScenarioException.class, () -> ScenarioFile.read(missing)))
        .hasMessage(missing + ": there is no such file");
    assertThat(catchThrowableOfType(ScenarioException.class, () -> ScenarioFile.read(folder)))
        .hasMessage(folder + ": expected a file, found a folder");
  }

  @Test
  @Timeout(60)
  void whateverIsInAFileEndsInAScenarioOrInSentences() throws IOException {
    SplittableRandom random = new SplittableRandom(11);
    for (int i = 0; i < 2000; i++) {
      byte[] bytes = EVERYTHING.getBytes(StandardCharsets.UTF_8);
      for (int j = 0; j < 1 + i % 8; j++) {
        String letters = " :-,[]{}&*#\n\"'0159.eabz\t";
        bytes[random.nextInt(bytes.length)] =
            (byte) letters.charAt(random.nextInt(letters.length()));
      }
      try {
        ScenarioFile.read(file(bytes));
      } catch (ScenarioException e) {
        assertThat(e.diagnostics()).isNotEmpty();
        ForPeople.check(e.getMessage());
      }
    }
  }

  private Scenario read(String text) throws IOException, ScenarioException {
    return ScenarioFile.read(file(text.getBytes(StandardCharsets.UTF_8)));
  }

  private Path file(byte[] bytes) throws IOException {
    return Files.write(folder.resolve("room.yaml"), bytes);
  }

  private Scenario rewritten(Scenario scenario) throws IOException, ScenarioException {
    Path file = folder.resolve("again.yaml");
    ScenarioFile.write(scenario, file);
    return ScenarioFile.read(file);
  }

  private List<String> diagnostics(String text) {
    try {
      return diagnostics(text.getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  /** Returns the mistakes, without the name of the file. */
  private List<String> diagnostics(byte[] bytes) throws IOException {
    Path file = file(bytes);
    ScenarioException wrong =
        catchThrowableOfType(ScenarioException.class, () -> ScenarioFile.read(file));
    assertThat(wrong).as("something is wrong").isNotNull();
    return wrong.diagnostics().stream()
        .map(
            diagnostic ->
                diagnostic.toString().substring(file.toString().length()).replaceFirst("^: ?", ""))
        .toList();
  }
}
