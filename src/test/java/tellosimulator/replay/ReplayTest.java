package tellosimulator.replay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.fault.Fault;
import tellosimulator.fault.LinkPreset;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.goal.Infraction;
import tellosimulator.goal.Scoring;
import tellosimulator.goal.Terms;
import tellosimulator.json.Json;
import tellosimulator.math.Vec3;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.recording.RecordedCommand;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordedScore;
import tellosimulator.recording.RecordingFixture;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.scenario.Description;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.Formation;
import tellosimulator.sim.SimConfig;
import tellosimulator.testing.AppPackets;
import tellosimulator.time.TimeFactor;
import tellosimulator.words.Phrase;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;

@Timeout(value = 300, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class ReplayTest {

  private static final Room HALL = new Room(9, 9, 4);

  private static final Scoring SCORING =
      new Scoring(
          Map.of(
              Infraction.TOUCH, 1.0,
              Infraction.CRASH, 2.0,
              Infraction.REFUSED, 0.25,
              Infraction.NOT_LANDED, 3.0),
          Optional.of(new Scoring.Par(1, 0.1)),
          Optional.of(new Scoring.Bonus(5, 1, 100)),
          new Scoring.Limits(-100, 100));

  @TempDir private Path parent;

  private static Scenario scenario(int drones, TimeFactor factor, Behavior behavior) {
    Obstacle pole =
        new Obstacle(
            "pole", new Shape.Cylinder(0.1, 2), new Vec3(1.5, 0, 0), 0, ObstacleAppearance.DEFAULT);
    SimConfig config =
        SimConfig.DEFAULT
            .withRoom(HALL, Formation.row(drones, Vec3.ZERO, HALL))
            .withProduct(Profile.EDU, behavior)
            .withTimeFactor(factor)
            .withLink(LinkPreset.IDEAL) // a program that waits for a lost reply waits forever
            .withSeed(3);
    Challenge challenge =
        new Challenge(
            List.of(
                new Goal.Reach(Terms.ANY.worth(10), new GoalRegion(new Vec3(0.5, 0, 0.8), 0.3))),
            true,
            OptionalDouble.empty(),
            false,
            Optional.of(SCORING));
    Scenario plain = Scenario.of(config.withArena(config.arena().withObstacles(List.of(pole))));
    return new Scenario(Description.NONE, plain.config(), plain.stations(), challenge);
  }

  private static final String MOVES =
      """
      1 command
      1 battery?
      1 takeoff
      1 forward 50
      1 cw 90
      1 curve 25 -25 0 25 -75 0 40
      1 flip l
      1 foo
      1 forward 5
      1 land
      """;

  private static final String STICKS =
      """
      1 command
      1 takeoff
      !1 rc 20 30 0 0
      states 10
      !1 rc 0 0 0 40
      1 attitude?
      states 5
      !1 rc 0 0 0 0
      1 up 30
      !1 emergency
      states 20
      1 battery?
      1 takeoff
      1 land
      """;

  private static final String SWARM =
      """
      1 command
      2 command
      fault loss state 30% burst 2 drone 1
      fault delay commands 20ms spread 30ms
      fault corrupt state 20% drone 2
      1 takeoff
      2 takeoff
      wind 1.5 0.3 0.7
      !1 rc 30 0 0 0
      states 8
      !2 rc -30 0 0 0
      states 20
      1 stop
      2 tof?
      2 land
      1 land
      """;

  private static final String COLLISION =
      """
      1 command
      1 takeoff
      !1 forward 300
      states 40
      1 battery?
      states 40
      reset 1
      1 command
      1 takeoff
      1 back 50
      1 land
      """;

  private static final String FLIGHTS =
      """
      1 command
      1 takeoff
      !1 forward 100
      states 5
      reset 1
      start 1 0.123456789 -0.3 0.7
      battery 1 61.7
      1 command
      1 takeoff
      1 forward 50
      power 1 off
      power 1 on
      1 command
      pass 3.5
      1 takeoff
      1 left 40
      1 land
      pass 4
      """;

  private static final String ANEW =
      """
      1 command
      1 takeoff
      1 forward 100
      restart 77
      1 command
      1 takeoff
      1 right 60
      1 land
      """;

  private static final String FLOOD =
      """
      1 command
      1 takeoff
      flood 200
      states 3
      1 land
      """;

  @Test
  void whatDiffersIsToldWithItsMoment() throws Exception {
    Path flight = flown(MOVES).get(0);
    change(flight, "inputs.jsonl", "forward 50", "forward 60");

    Repetition repetition = repeated(flight);

    assertThat(repetition.identical()).isFalse();
    assertThat(repetition.differences())
        .extracting(Difference::file)
        .contains("wire.jsonl", "events.jsonl", "flight.csv");
    Difference wire = repetition.differences().get(0);
    assertThat(wire.time()).isPresent();
    assertThat(wire.recorded()).contains("forward 50");
    assertThat(wire.replayed()).contains("forward 60");
  }

  @ParameterizedTest
  @ValueSource(strings = {MOVES, STICKS, COLLISION, FLIGHTS})
  void theScoreIsTheSameAgain(String script) throws Exception {
    List<Path> flights =
        RecordedProgram.run(
            scenario(1, new TimeFactor(20), Behavior.REPORT), script, parent.resolve("flown"));
    for (Path flight : flights) {
      Optional<RecordedScore> recorded = RecordedFlight.readOutline(flight).run().score();
      Repetition repetition = repeated(flight);

      assertThat(RecordedFlight.readOutline(repetition.recording()).run().score())
          .isEqualTo(recorded)
          .isPresent();
    }
  }

  @Test
  void aRecordingThatWasCutOffIsComparedAsFarAsItGoes() throws Exception {
    Path flight = flown(MOVES).get(0);
    change(flight, "run.json", ", \"ended\": [0-9.]+", "");
    Files.delete(flight.resolve("goals.json"));
    for (String file : List.of("wire.jsonl", "events.jsonl", "flight.csv")) {
      byte[] all = Files.readAllBytes(flight.resolve(file));
      Files.write(flight.resolve(file), Arrays.copyOf(all, all.length * 2 / 3));
    }

    Repetition repetition = repeated(flight);

    assertThat(repetition.differences()).extracting(Difference::file).isSubsetOf("goals.json");
    assertThat(repetition.remarks()).singleElement().asString().contains("cut off");
  }

  @Test
  void withoutInputsTheSameCommandsAreFlown() throws Exception {
    Path flight = flown(MOVES).get(0);
    Files.delete(flight.resolve("inputs.jsonl"));

    Replay replay = Replay.of(flight);
    Repetition repetition = repeated(flight);

    assertThat(replay.exact()).isFalse();
    assertThat(repetition.remarks()).singleElement().asString().contains("only its commands");
    assertThat(Files.readString(repetition.recording().resolve("wire.jsonl")))
        .contains("forward 50", "flip l");
  }

  /**
   * The recorded takeoff and move are shorter than the simulated ones, and than those of any drone.
   */
  @Test
  void commandsOfARealDroneWaitForTheRepliesOfTheSimulatedOne() throws Exception {
    Path flight = parent.resolve("real");
    new RecordingFixture(flight)
        .run("{\"format\":1,\"program\":\"1.0.0\",\"started\":7.0,\"realDrone\":\"192.168.10.1\"}")
        .with(
            "wire.jsonl",
            """
            {"t":7.0,"drone":1,"kind":"command","from":"127.0.0.1:9","to":"192.168.10.1:8889","text":"takeoff"}
            {"t":7.5,"drone":1,"kind":"reply","from":"192.168.10.1:8889","to":"127.0.0.1:9","text":"ok"}
            {"t":7.6,"drone":1,"kind":"command","from":"127.0.0.1:9","to":"192.168.10.1:8889","text":"forward 100"}
            {"t":8.0,"drone":1,"kind":"command","from":"127.0.0.1:9","to":"192.168.10.1:8889","text":"battery?"}
            {"t":8.0,"drone":1,"kind":"reply","from":"192.168.10.1:8889","to":"127.0.0.1:9","text":"87"}
            {"t":8.2,"drone":1,"kind":"reply","from":"192.168.10.1:8889","to":"127.0.0.1:9","text":"ok"}
            {"t":8.3,"drone":1,"kind":"command","from":"127.0.0.1:9","to":"192.168.10.1:8889","text":"land"}
            {"t":9.5,"drone":1,"kind":"reply","from":"192.168.10.1:8889","to":"127.0.0.1:9","text":"ok"}
            """);

    Repetition repetition = repeated(flight);

    List<RecordedCommand> commands = RecordedFlight.read(repetition.recording()).commands();
    assertThat(commands)
        .extracting(each -> each.text() + " " + each.outcome())
        .containsExactly(
            "command ANSWERED",
            "takeoff ANSWERED",
            "forward 100 ANSWERED",
            "battery? ANSWERED",
            "land ANSWERED");
    assertThat(commands.get(2).sent() - commands.get(1).answered().getAsDouble())
        .as("after the takeoff's reply, as its program")
        .isCloseTo(0.1, within(0.006));
    assertThat(commands.get(3).sent() - commands.get(2).sent())
        .as("after the move, whose reply its program did not wait for")
        .isCloseTo(0.4, within(0.006));
    assertThat(commands.get(1).duration().getAsDouble())
        .as("as a takeoff of real drones was measured")
        .isGreaterThan(5);
    assertThat(repetition.exact()).isFalse();
    assertThat(repetition.differences()).isEmpty();
    assertThat(repetition.remarks()).asString().contains("a real drone flew, so that only its");
  }

  /** Replays twenty minutes of the day-long flight of the endurance test. */
  @Test
  void aLongFlightIsFlownAgainToTheByte() throws Exception {
    Repetition repetition = LongFlight.repeat(1 / 3.0, parent);

    assertThat(repetition.differences()).isEmpty();
    assertThat(repetition.remarks()).isEmpty();
    assertThat(Files.readAllLines(repetition.recording().resolve("flight.csv")).size())
        .isGreaterThan(20_000);
    assertThat(digest(repetition.recording()))
        .as("the same on each JDK; changed by whatever changes a flight or its files")
        .isEqualTo("82a862a89c95c02e");
  }

  /** Returns a digest of everything that is determined by the simulation. */
  private static String digest(Path recording) throws Exception {
    MessageDigest digest = MessageDigest.getInstance("SHA-256");
    for (String name : List.of("wire.jsonl", "events.jsonl", "flight.csv")) {
      try (LineFile file = new LineFile(recording.resolve(name))) {
        for (Optional<String> line = file.next(); line.isPresent(); line = file.next()) {
          digest.update(line.get().getBytes(StandardCharsets.UTF_8));
        }
      }
    }
    return HexFormat.of().formatHex(digest.digest(), 0, 8);
  }

  @Test
  void inputsThatAreDamagedAreToldAndThoseThatWereCutOffAreNot() throws Exception {
    Path flight = flown(MOVES).get(0);
    change(flight, "inputs.jsonl", "\\{([^\n]*)flip l", "{x$1flip l");

    assertThat(repeated(flight).remarks())
        .extracting(Phrase::english)
        .containsExactly("1 lines of inputs.jsonl are damaged and left out");

    change(flight, "inputs.jsonl", "\\{x[^\n]*\n", "");
    change(flight, "inputs.jsonl", "\n[^\n]*land[^\n]*\n$", "\n{\"step\":12");
    assertThat(repeated(flight).remarks()).isEmpty();
  }

  @Test
  void anInputThatCannotBeIsASentence() throws Exception {
    Path flight = flown(MOVES).get(0);
    change(flight, "inputs.jsonl", "\"drone\": 1(,[^\n]*flip l)", "\"drone\": 7$1");

    assertThatThrownBy(() -> repeated(flight))
        .isInstanceOf(IOException.class)
        .hasMessageMatching("its inputs are damaged at [0-9.]+ s: .*drone 7.*");
  }

  @ParameterizedTest
  @ValueSource(strings = {"-5", "1e300", "987654321"})
  void anEndThatCannotBeIsNotWaitedFor(String ended) throws Exception {
    Path flight = flown(MOVES).get(0);
    change(flight, "run.json", "\"ended\": [0-9.]+", "\"ended\": " + ended);

    Repetition repetition = repeated(flight);

    assertThat(repetition.differences()).isEmpty();
    assertThat(repetition.remarks())
        .extracting(Phrase::english)
        .containsExactly("its end is damaged, so that it was flown as far as its lines go");
  }

  @Test
  void aBeginningOfAnotherVersionIsToldAndTheCommandsAreFlown() throws Exception {
    Path flight = flown(MOVES).get(0);
    change(flight, "inputs.jsonl", "^\\{\"config\"", "{\"later\"");

    Replay replay = Replay.of(flight);

    assertThat(replay.exact()).isFalse();
    assertThat(repeated(flight).remarks())
        .extracting(Phrase::english)
        .singleElement()
        .asString()
        .startsWith("this version cannot read what it begins from");
  }

  /**
   * A fault that is active from the start begins before the drone is on, and again with each new
   * run.
   */
  @ParameterizedTest
  @ValueSource(strings = {"yaw-drift 2", "delay replies 20ms", "state-stopped for 2s"})
  void faultsThatActFromTheStartBeginAtTheSameMoment(String fault) throws Exception {
    Scenario plain = scenario(1, TimeFactor.MAX, Behavior.REPORT);
    Scenario faulty = plain.withConfig(plain.config().withFaults(List.of(Fault.of(fault))));

    List<Path> flights = RecordedProgram.run(faulty, ANEW, parent.resolve("flown"));

    assertThat(flights).hasSize(2);
    for (Path flight : flights) {
      assertThat(repeated(flight).differences()).isEmpty();
    }
  }

  private List<Path> flown(String program) throws IOException {
    return RecordedProgram.run(
        scenario(1, TimeFactor.MAX, Behavior.REPORT), program, parent.resolve("flown"));
  }

  private Repetition repeated(Path flight) throws Exception {
    return Replay.of(flight).repeat(RecordingFolder.at(parent.resolve("replayed")));
  }

  private static void change(Path folder, String file, String part, String replacement)
      throws IOException {
    String before = Files.readString(folder.resolve(file));
    String after = before.replaceAll(part, replacement);
    assertThat(after).isNotEqualTo(before);
    Files.writeString(folder.resolve(file), after);
  }

  @ParameterizedTest(name = "{0} {1} {2}")
  @CsvSource(
      textBlock =
          """
          MOVES,     max, report
          MOVES,     40,  measured
          STICKS,    max, measured
          STICKS,    20,  report
          SWARM,     max, measured
          SWARM,     20,  report
          COLLISION, max, measured
          COLLISION, 20,  report
          FLIGHTS,   max, measured
          FLIGHTS,   40,  report
          ANEW,      max, measured
          ANEW,      40,  report
          FLOOD,     10,  measured
          """)
  void whatCameOverSocketsIsFlownAgainToTheByte(String name, String factor, String behavior)
      throws Exception {
    String program = PROGRAMS.get(name);
    TimeFactor pace =
        factor.equals("max") ? TimeFactor.MAX : new TimeFactor(Double.parseDouble(factor));
    List<Path> flights =
        RecordedProgram.run(
            scenario(
                name.equals("SWARM") ? 2 : 1,
                pace,
                Behavior.valueOf(behavior.toUpperCase(Locale.ROOT))),
            program,
            parent.resolve("flown"));

    assertThat(flights).isNotEmpty();
    for (Path flight : flights) {
      Repetition repetition =
          Replay.of(flight).repeat(RecordingFolder.at(parent.resolve("replayed")));
      assertThat(repetition.remarks()).isEmpty();
      assertThat(repetition.differences()).as(flight.toString()).isEmpty();
      assertThat(Files.size(repetition.recording().resolve("wire.jsonl"))).isGreaterThan(500);
    }
  }

  private static final Map<String, String> PROGRAMS =
      Map.of(
          "MOVES",
          MOVES,
          "STICKS",
          STICKS,
          "SWARM",
          SWARM,
          "COLLISION",
          COLLISION,
          "FLIGHTS",
          FLIGHTS,
          "ANEW",
          ANEW,
          "FLOOD",
          FLOOD);

  @Test
  void packetsToARealDroneAreFlownAgain() throws Exception {
    Path flight = parent.resolve("app");
    new RecordingFixture(flight)
        .run("{\"format\":1,\"program\":\"1.0.0\",\"started\":7.0,\"realDrone\":\"192.168.10.1\"}")
        .with(
            "wire.jsonl",
            wire(7, "command", AppPackets.TAKEOFF)
                + wire(7.1, "reply", AppPackets.TAKEOFF_DONE)
                + wire(14, "command", AppPackets.STICKS)
                + wire(14.02, "command", AppPackets.STICKS)
                + wire(15, "command", AppPackets.LAND)
                + wire(15.1, "reply", AppPackets.LAND_DONE));

    Repetition repetition = repeated(flight);

    List<RecordedCommand> commands = RecordedFlight.read(repetition.recording()).commands();
    assertThat(commands)
        .extracting(each -> each.words() + " " + each.outcome())
        .startsWith("conn_req (app) ANSWERED", "takeoff (app) ANSWERED")
        .contains("rc 0 50 0 -100 (app) UNANSWERED", "land (app) ANSWERED");
    assertThat(commands.get(2).sent() - commands.get(1).sent()).isCloseTo(7, within(0.006));
  }

  private static String wire(double time, String kind, String text) {
    return Json.text(Map.of("t", time, "drone", 1, "kind", kind, "text", text)) + "\n";
  }
}
