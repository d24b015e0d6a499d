package tellosimulator.recording;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.entry;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.goal.GoalWatch;
import tellosimulator.goal.Infraction;
import tellosimulator.goal.Score;
import tellosimulator.goal.Scoring;
import tellosimulator.goal.Terms;
import tellosimulator.math.Vec3;
import tellosimulator.network.WireTap.Kind;
import tellosimulator.scenario.Description;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenario.ScenarioFile;
import tellosimulator.sim.Control;
import tellosimulator.sim.Formation;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimInput;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.testing.AppPackets;
import tellosimulator.testing.CapturedLog;
import tellosimulator.testing.SimulatedDrones;
import tellosimulator.testing.SteppedDrone;
import tellosimulator.words.Phrase;
import tellosimulator.world.Room;

@Timeout(value = 120, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class FlightRecorderTest {

  private static final int COMMAND = 22;
  private static final InetSocketAddress DRONE = SteppedDrone.address("192.168.10.1", 8889);
  private static final InetSocketAddress CLIENT = SteppedDrone.address("192.168.10.100", 9001);

  @TempDir private Path parent;

  private final BlockingQueue<Phrase> told = new LinkedBlockingQueue<>();
  private FlightRecorder recorder;
  private SimulatedDrones drones;

  /** Passes on events once there is a recorder. */
  private final class Forwarding implements SimListener {
    @Override
    public void event(SimEvent event) {
      if (drones != null) {
        recorder.event(event);
      }
    }

    @Override
    public void stepped(SimSnapshot snapshot) {
      recorder.stepped(snapshot);
    }
  }

  private void begin(SimConfig config) {
    begin(Scenario.of(config), RecordingFolder.at(parent), new EntryQueue());
  }

  private void begin(Scenario scenario, RecordingFolder folder, EntryQueue queue) {
    GoalWatch goals = new GoalWatch(scenario.challenge(), news -> recorder.event(news));
    FlightRecorder.Subject subject =
        new FlightRecorder.Subject("A test", scenario, List.of("--headless"), goals);
    recorder = FlightRecorder.start(folder, subject, told::add, queue);
    drones = new SimulatedDrones(scenario.config(), List.of(goals, new Forwarding()));
    recorder.follow(() -> drones.snapshot().time(), () -> drones.snapshot());
  }

  private void receive(String text) {
    recorder.onInput(
        drones.snapshot().time(),
        new SimInput.Datagram(1, new Peer(CLIENT, DRONE), WireText.encode(text)));
  }

  @AfterEach
  void close() {
    recorder.close();
  }

  @Test
  void nothingIsThereBeforeATakeoff() throws IOException {
    begin(SimConfig.DEFAULT);
    drones.fly("command", "battery?", "motoron");
    drones.advance(10);
    recorder.close();

    assertThat(RecordingFiles.in(parent)).isEmpty();
    assertThat(told).isEmpty();
  }

  @Test
  void aFlightIsOverWhenAllHaveBeenDownForThreeSeconds() throws IOException {
    begin(SimConfig.DEFAULT);
    drones.fly("command", "takeoff", "forward 100", "land");
    double landed = drones.snapshot().time().seconds();
    drones.advance(10);
    recorder.close();

    RecordingFiles files = RecordingFiles.only(parent);
    assertThat(files.run())
        .contains(
            entry("format", 1L),
            entry("seed", 1L),
            entry("timeFactor", "1"),
            entry("scenario", "A test"),
            entry("options", List.of("--headless")),
            entry("room", Map.of("width", 500.0, "depth", 500.0, "height", 300.0)),
            entry("result", "none"));
    double started = (double) files.run().get("started");
    double ended = (double) files.run().get("ended");
    assertThat(files.events("took-off")).singleElement().extracting("t").isEqualTo(started);
    assertThat(ended).isCloseTo(landed + 3, within(0.1));
    assertThat(files.events("command"))
        .extracting(event -> event.get("command"))
        .containsExactly("command", "takeoff", "forward 100", "land");
    assertThat(files.events("reply"))
        .allSatisfy(event -> assertThat(event).containsEntry("reply", "ok"));
    List<List<String>> rows = files.rows();
    assertThat(rows).hasSize((int) Math.round((ended - started) * 20) + 1);
    assertThat(Double.parseDouble(rows.get(0).get(0))).isEqualTo(started);
    List<String> last = rows.get(rows.size() - 1);
    assertThat(Double.parseDouble(last.get(2))).as("x").isCloseTo(100, within(2.0));
    assertThat(last.get(11)).isEqualTo("grounded");
    assertThat(rows).anyMatch(row -> row.get(COMMAND).equals("forward 100"));
    assertThat(last.get(COMMAND)).isEmpty();
  }

  @Test
  void theScenarioIsKeptAsItIsFlown() throws Exception {
    begin(SimConfig.DEFAULT);
    drones.control(new Control.SetRoom(new Room(4, 6, 3)));
    drones.fly("command", "takeoff");
    recorder.close();

    RecordingFiles files = RecordingFiles.only(parent);
    Scenario kept = ScenarioFile.read(files.folder().resolve("scenario.yaml"));
    assertThat(kept.config().arena().room()).isEqualTo(new Room(4, 6, 3));
  }

  @Test
  void eachDroneHasRowsAndOneThatIsUpKeepsTheFlightGoing() throws IOException {
    begin(three());
    drones.flyAll("command");
    drones.fly(1, "takeoff");
    drones.fly(2, "takeoff");
    drones.fly(1, "land");
    drones.advance(5);
    drones.fly(2, "land");
    drones.advance(4);
    recorder.close();

    RecordingFiles files = RecordingFiles.only(parent);
    assertThat(files.events("took-off", "landed"))
        .extracting(event -> event.get("kind") + " " + event.get("drone"))
        .containsExactly("took-off 1", "took-off 2", "landed 1", "landed 2");
    List<List<String>> rows = files.rows();
    for (String drone : List.of("1", "2", "3")) {
      assertThat(rows.stream().filter(row -> row.get(1).equals(drone))).hasSize(rows.size() / 3);
    }
    assertThat((List<?>) files.run().get("drones")).hasSize(3);
  }

  private static SimConfig three() {
    return SimConfig.DEFAULT.withRoom(Room.DEFAULT, Formation.row(3, Vec3.ZERO, Room.DEFAULT));
  }

  @Test
  void eachFlightHasAFolderAndWhatCameInBetweenBelongsToTheNext() throws IOException {
    begin(SimConfig.DEFAULT);
    drones.fly("command", "takeoff", "land");
    drones.advance(4);
    drones.fly("speed?", "takeoff", "land");
    drones.advance(4);
    recorder.close();

    List<RecordingFiles> flights = RecordingFiles.in(parent);
    assertThat(flights).hasSize(2);
    assertThat(flights.get(1).events("command"))
        .extracting(event -> event.get("command"))
        .containsExactly("speed?", "takeoff", "land");
    assertThat(flights).allSatisfy(flight -> assertThat(flight.run()).containsKey("ended"));
  }

  @Test
  void restartResetAndPowerOffEndAFlightAtOnce() throws IOException {
    begin(SimConfig.DEFAULT);
    drones.fly("command", "takeoff");
    double restarted = drones.snapshot().time().seconds();
    drones.control(new Control.NewRun(SimConfig.DEFAULT));
    drones.control(new Control.Power(1, true));
    drones.fly("command", "takeoff");
    drones.control(new Control.Reset(1));
    drones.fly("command", "takeoff");
    drones.control(new Control.Power(1, false));
    recorder.close();

    List<RecordingFiles> flights = RecordingFiles.in(parent);
    assertThat(flights).hasSize(3);
    assertThat(flights.get(0).run()).containsEntry("ended", restarted);
    assertThat(flights.get(1).events("command"))
        .as("nothing of before the restart")
        .extracting(event -> event.get("command"))
        .containsExactly("command", "takeoff");
    assertThat(flights).allSatisfy(flight -> assertThat(flight.run()).containsKey("ended"));
  }

  @Test
  void theEndOfTheProgramEndsAFlight() throws IOException {
    begin(SimConfig.DEFAULT);
    drones.fly("command", "takeoff");
    double now = drones.snapshot().time().seconds();
    recorder.close();

    assertThat(RecordingFiles.only(parent).run()).containsEntry("ended", now);
  }

  @Test
  void goalsHaveTheMomentAtWhichTheyWereReached() throws IOException {
    Challenge challenge =
        new Challenge(
            List.of(
                new Goal.Reach(Terms.ANY, new GoalRegion(new Vec3(0, 0, 0.2), 0.1)),
                new Goal.Reach(Terms.ANY, new GoalRegion(new Vec3(0, 0, 2.5), 0.1))),
            true,
            OptionalDouble.empty(),
            false);
    Scenario plain = Scenario.of(SimConfig.DEFAULT);
    begin(
        new Scenario(Description.NONE, plain.config(), plain.stations(), challenge),
        RecordingFolder.at(parent),
        new EntryQueue());
    drones.fly("command", "takeoff", "land");
    recorder.close();

    RecordingFiles files = RecordingFiles.only(parent);
    assertThat(files.run()).containsEntry("result", "open");
    assertThat(files.goals()).hasSize(2);
    assertThat(files.goals().get(1)).doesNotContainKey("reached");
    double reached = (double) files.goals().get(0).get("reached");
    assertThat(files.events("goal")).singleElement().extracting("t").isEqualTo(reached);
  }

  @Test
  void theScoreIsKeptWithItsReasons() throws Exception {
    Goal reach = new Goal.Reach(Terms.ANY.worth(10), new GoalRegion(new Vec3(0, 0, 0.2), 0.1));
    Scoring scoring =
        new Scoring(
            Map.of(Infraction.NOT_LANDED, 2.5),
            Optional.empty(),
            Optional.empty(),
            Scoring.Limits.DEFAULT);
    Challenge challenge =
        Challenge.NONE.withGoals(List.of(reach)).withScoring(Optional.of(scoring));
    Scenario plain = Scenario.of(SimConfig.DEFAULT);
    begin(
        new Scenario(Description.NONE, plain.config(), plain.stations(), challenge),
        RecordingFolder.at(parent),
        new EntryQueue());
    drones.fly("command", "takeoff");
    drones.advance(25);
    recorder.close();

    RecordedFlight flight = RecordedFlight.read(RecordingFiles.only(parent).folder());
    RecordedScore recorded = flight.run().score().orElseThrow();
    assertThat(recorded.score().phrase().english()).isEqualTo("score: 7.5 of 10 points");
    assertThat(recorded.score().entries())
        .extracting(entry -> Score.number(entry.points()) + ": " + entry.why())
        .containsExactly(
            "10: reached goal 1 of 1: reach x 0, y 0, z 20 cm",
            "-2.5: drone 1 lands by itself: no command came for 15 s");
    assertThat(recorded.takeoff() + recorded.score().entries().get(0).second())
        .isCloseTo(flight.goals().get(0).reached().getAsDouble(), within(1e-3));
    assertThat(flight.scenario().orElseThrow().challenge()).isEqualTo(challenge);
  }

  @Test
  void sticksCommandsAndSensorsAreInTheRows() throws IOException {
    begin(SimConfig.DEFAULT);
    drones.fly("command", "takeoff");
    String line = "mid:-1;pitch:0;yaw:-45;tof:61;h:50;bat:87;baro:12.34;time:3;\r\n";
    recorder.sent(1, Kind.STATE, DRONE, CLIENT, line.getBytes(StandardCharsets.ISO_8859_1));
    drones.send(1, "rc 0 20 -10 5");
    drones.advance(0.2);
    drones.send(1, "rc 0 200 0 0");
    drones.advance(0.2);
    drones.fly("stop");
    drones.advance(0.2);
    recorder.close();

    List<List<String>> rows = RecordingFiles.only(parent).rows();
    assertThat(rows.get(0).subList(13, 22)).containsExactly("0", "0", "0", "0", "", "", "", "", "");
    assertThat(rows)
        .anyMatch(row -> row.subList(13, 17).equals(List.of("0", "20", "-10", "5")))
        .noneMatch(row -> row.get(14).equals("200"));
    List<String> last = rows.get(rows.size() - 1);
    assertThat(last.subList(13, 22))
        .containsExactly("0", "0", "0", "0", "50", "61", "12.34", "-45", "87");
  }

  @Test
  void whateverIsSentSurvives() throws IOException {
    begin(SimConfig.DEFAULT);
    String nasty = "</script><script>\u0000\u0001\n\r\t\"\\\u007f\u0085\u00ff,;";
    drones.fly("command", "takeoff");
    receive(nasty);
    drones.send(1, nasty);
    byte[] picture = {0, 0, 1, 2, 3};
    recorder.sent(1, Kind.VIDEO, DRONE, CLIENT, picture);
    recorder.close();

    RecordingFiles files = RecordingFiles.only(parent);
    assertThat(files.wire("command"))
        .singleElement()
        .satisfies(
            datagram ->
                assertThat(datagram)
                    .contains(
                        entry("text", nasty),
                        entry("dir", "in"),
                        entry("from", "192.168.10.100:9001"),
                        entry("to", "192.168.10.1:8889")));
    assertThat(files.events("refused")).singleElement().extracting("command").isEqualTo(nasty);
    // sha256sum of the five bytes
    assertThat(files.wire("video"))
        .singleElement()
        .satisfies(
            datagram ->
                assertThat(datagram)
                    .contains(entry("size", 5L), entry("sha256", "a498efa8d0759e7b"))
                    .doesNotContainKey("text"));
    assertThat(files.text("wire.jsonl") + files.text("events.jsonl")).isASCII();
  }

  @Test
  void noMoreThanAThousandLinesOfBeforeAreKept() throws IOException {
    begin(SimConfig.DEFAULT);
    drones.fly("command");
    for (int i = 0; i < 1200; i++) {
      receive("battery? " + i);
    }
    drones.fly("takeoff");
    recorder.close();

    List<Map<String, Object>> before = RecordingFiles.only(parent).wire("command");
    assertThat(before).hasSizeBetween(990, 1000);
    assertThat(before.get(before.size() - 1)).containsEntry("text", "battery? 1199");
  }

  @Test
  void aFullDiskEndsTheRecordingWithASentenceAndNeverTheFlight() throws Exception {
    List<Path> made = new ArrayList<>();
    RecordingFolder.Disk disk =
        file -> {
          made.add(file);
          return file.endsWith("events.jsonl") ? new FullDisk() : Files.newOutputStream(file);
        };
    begin(
        Scenario.of(SimConfig.DEFAULT),
        new RecordingFolder(parent, Integer.MAX_VALUE, disk),
        new EntryQueue());
    try (CapturedLog log = CapturedLog.of(RecordingWriter.class)) {
      drones.fly("command", "takeoff");

      String sentence = told.take().english();
      assertThat(sentence)
          .matches("the recording .* ended, because it cannot be written: No space left on device");
      assertThat(log.next()).isEqualTo(sentence);
      assertThat(drones.fly("forward 50", "land")).containsExactly("ok", "ok");
      recorder.close();
      assertThat(told).as("one sentence").isEmpty();
    }
    assertThat(made).extracting(Path::getFileName).map(Path::toString).contains("events.jsonl");
    assertThat(RecordingFiles.only(parent).run()).doesNotContainKey("ended");
  }

  /** Rejects all writes. */
  private static final class FullDisk extends OutputStream {
    @Override
    public void write(int value) throws IOException {
      throw new IOException("No space left on device");
    }
  }

  @Test
  void aFolderThatCannotBeThereEndsTheRecordingAndTheNextFlightIsTriedAnew() throws Exception {
    Path folder = parent.resolve("flights");
    Files.createFile(folder);
    try (CapturedLog log = CapturedLog.of(RecordingWriter.class)) {
      begin(Scenario.of(SimConfig.DEFAULT), RecordingFolder.at(folder), new EntryQueue());
      drones.fly("command", "takeoff");
      assertThat(told.take().english()).contains("flights").contains("cannot be written");
      assertThat(log.next()).contains("flights");
    }

    Files.delete(folder);
    drones.fly("land");
    drones.advance(4);
    drones.fly("takeoff", "land");
    recorder.close();

    assertThat(RecordingFiles.only(folder).events("took-off")).hasSize(1);
  }

  @Test
  void tooMuchAtOnceEndsTheRecordingAndNobodyWaits() throws Exception {
    begin(Scenario.of(SimConfig.DEFAULT), RecordingFolder.at(parent), new EntryQueue(50));
    try (CapturedLog log = CapturedLog.of(RecordingWriter.class)) {
      drones.fly("command", "takeoff");
      for (int i = 0; i < 200_000 && told.isEmpty(); i++) {
        receive("battery?");
      }

      assertThat(told.take().english()).endsWith("ended, because too much waited to be written");
      assertThat(log.next()).endsWith("too much waited to be written");
    }
    assertThat(drones.fly("land")).containsExactly("ok");
    drones.advance(4);
    recorder.close();
    assertThat(RecordingFiles.only(parent).run()).doesNotContainKey("ended");
  }

  @Test
  void flightsAreNotRecordedWhileThatIsOff() throws IOException {
    begin(SimConfig.DEFAULT);
    drones.fly("command", "takeoff");
    recorder.setRecording(false);
    drones.fly("land");
    drones.advance(4);
    drones.fly("takeoff", "land");
    drones.advance(4);
    recorder.setRecording(true);
    drones.fly("takeoff");
    recorder.close();

    List<RecordingFiles> flights = RecordingFiles.in(parent);
    assertThat(flights).hasSize(2);
    assertThat(flights.get(0).events("landed")).isEmpty();
    assertThat(flights.get(0).run()).containsKey("ended");
    assertThat(flights.get(1).events("command"))
        .extracting(event -> event.get("command"))
        .containsExactly("takeoff");
  }

  @Test
  void aFlightEndsBeforeAnInputThatIsNotRecorded() throws IOException {
    begin(SimConfig.DEFAULT);
    drones.fly("command", "takeoff");
    recorder.setRecording(false);
    receive("forward 50"); // while the simulation is paused
    recorder.setRecording(true);
    drones.fly("land");
    drones.advance(4);
    recorder.close();

    RecordingFiles flight = RecordingFiles.only(parent);
    assertThat(flight.run()).containsKey("ended");
    assertThat(flight.events("landed")).isEmpty();
  }

  @Test
  void packetsOfTheAppAreRecordedWithTheirWordsAndTheirSticks() throws Exception {
    begin(SimConfig.DEFAULT);
    drones.fly(AppPackets.CONNECT, AppPackets.TAKEOFF);
    drones.advance(3);
    receive(AppPackets.STICKS);
    recorder.sent(1, Kind.STATE, DRONE, CLIENT, WireText.encode(AppPackets.FLIGHT_DATA));
    drones.send(1, AppPackets.STICKS);
    drones.advance(0.2);
    recorder.close();

    RecordingFiles files = RecordingFiles.only(parent);
    assertThat(files.wire("command"))
        .singleElement()
        .satisfies(
            datagram ->
                assertThat(datagram)
                    .contains(
                        entry("text", AppPackets.STICKS), entry("words", "rc 0 50 0 -100 (app)")));
    assertThat(files.wire("state"))
        .singleElement()
        .extracting("words")
        .isEqualTo("flight data (app)");
    List<List<String>> rows = files.rows();
    assertThat(rows.get(rows.size() - 1).subList(13, 17)).containsExactly("0", "50", "0", "-100");
    assertThat(RecordedFlight.read(files.folder()).commands())
        .extracting(each -> each.words() + " " + each.outcome())
        .containsExactly(
            "conn_req (app) ANSWERED", "takeoff (app) ANSWERED", "rc 0 50 0 -100 (app) UNANSWERED");
  }
}
