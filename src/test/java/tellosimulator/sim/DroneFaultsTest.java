package tellosimulator.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.fault.Fault;
import tellosimulator.fault.LinkPreset;
import tellosimulator.math.Vec3;
import tellosimulator.model.FlightPhase;
import tellosimulator.model.PadMode;
import tellosimulator.testing.SteppedDrone;
import tellosimulator.testing.SteppedDrone.Sent;
import tellosimulator.world.Arena;
import tellosimulator.world.MissionPad;

/** The effects of drone, sensor and state faults on the wire. */
class DroneFaultsTest {

  @ParameterizedTest
  @ValueSource(
      strings = {
        "up 30",
        "forward 100",
        "cw 90",
        "go 50 0 0 50",
        "curve 25 -25 0 25 -75 0 40",
        "flip f",
        "go 0 0 60 50 m1",
        "jump 50 0 60 50 0 m1 m2"
      })
  void withoutAValidImuMovesAreRefused(String move) {
    SteppedDrone drone = flying("no-valid-imu at 0s");

    assertThat(drone.ask(move)).isEqualTo("error No valid imu");
    assertThat(lastWords(drone))
        .isEqualTo(
            "`"
                + move
                + "` refused: the fault no-valid-imu 10cm/s at 0s acts; answered `error No"
                + " valid imu`");
  }

  @Test
  void withoutAValidImuTakeoffSticksStopAndLandWork() {
    SteppedDrone drone = flying("no-valid-imu 0cm/s");
    drone.send("rc 0 50 0 0");
    drone.advance(2);
    assertThat(drone.state().motion().position().x()).isGreaterThan(0.3);
    assertThat(drone.ask("stop")).isEqualTo("ok");
    drone.advance(3);
    assertThat(drone.ask("battery?")).isNotEmpty();
    assertThat(drone.ask("land")).isEqualTo("ok");
  }

  /** It drifts in one direction for at least two seconds, and so by more than 20 cm. */
  @Test
  void withoutAValidImuItDrifts() {
    SteppedDrone drone = flying("no-valid-imu 20cm/s");
    double farthest = 0;
    Vec3 start = drone.state().motion().position();
    for (int i = 0; i < 40; i++) {
      drone.advance(0.1);
      farthest = Math.max(farthest, drone.state().motion().position().distanceTo(start));
    }

    assertThat(farthest).isBetween(0.2, 0.81);
    assertThat(drone.state().motion().velocity().norm()).isCloseTo(0.2, within(0.1));
  }

  @Test
  void aMoveThatRunsIsCutOff() {
    SteppedDrone drone = flying("no-valid-imu after \"battery?\" for 1s");
    drone.send("forward 100");
    drone.advance(1);
    drone.send("rc 0 0 0 0");
    drone.control(new Control.InjectFault(Fault.of("no-valid-imu for 2s")));
    drone.advance(0.1);

    assertThat(lastReply(drone)).isEqualTo("error No valid imu");
    drone.advance(2);
    assertThat(drone.ask("up 30")).isEqualTo("ok");
  }

  @Test
  void inTheDarkItDriftsAndThenHasNoValidImu() {
    SteppedDrone drone = flying("dark at 0s time 6s");

    assertThat(drone.ask("cw 90")).isEqualTo("ok");
    assertThat(drone.state().motion().velocity().norm()).isGreaterThan(0.05);
    drone.advance(4);
    assertThat(drone.ask("cw 90")).isEqualTo("error No valid imu");
  }

  @Test
  void aMoveShortlyAfterAnOkOrSticksIsRefused() {
    SteppedDrone drone = flying("not-joystick 100% time 1s");

    assertThat(drone.ask("forward 50")).isEqualTo("error Not joystick");
    assertThat(lastWords(drone)).contains("the fault not-joystick 100% time 1s acts");
    drone.advance(1.1);
    assertThat(drone.ask("forward 50")).isEqualTo("ok");
    drone.advance(1.1);
    drone.send("rc 0 0 0 0");
    assertThat(drone.ask("flip l")).isEqualTo("error Not joystick");
    assertThat(drone.ask("sdk?")).as("no move").isEqualTo("20\r\n");
    assertThat(drone.ask("land")).isEqualTo("ok");
  }

  @Test
  void aShareOfTheMovesIsRefused() {
    SteppedDrone drone = flying("not-joystick 50%");

    List<String> replies = new ArrayList<>();
    for (int i = 0; i < 40; i++) {
      replies.add(drone.ask(i % 2 == 0 ? "cw 90" : "ccw 90"));
      drone.ask("speed 50"); // an `ok`
    }

    assertThat(replies).filteredOn("error Not joystick"::equals).hasSizeBetween(10, 30);
    assertThat(replies).filteredOn("ok"::equals).hasSizeBetween(10, 30);
  }

  @Test
  void aTriggerRefusesTheMoveAfterIt() {
    SteppedDrone drone = flying("not-joystick 100% after \"rc\" for 2s");

    assertThat(drone.ask("up 20")).isEqualTo("ok");
    drone.send("rc 0 0 0 0");
    assertThat(drone.ask("up 20")).isEqualTo("error Not joystick");
    drone.advance(2.1);
    assertThat(drone.ask("up 20")).isEqualTo("ok");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"takeoff", "land", "battery?", "streamon", "speed 50", "rc 0 0 0 0", "mon", "go"})
  void aDroneThatWasNeverActivatedKnowsCommandAlone(String command) {
    SteppedDrone drone = connected("unactivated");

    assertThat(drone.ask(command))
        .isEqualTo(command.equals("go") ? "unknown command: go" : "error");
    assertThat(drone.ask("command")).isEqualTo("ok");
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.GROUNDED);
  }

  @Test
  void aSensorErrorKeepsItOnTheGround() {
    SteppedDrone drone = connected("sensor-error");

    assertThat(drone.ask("takeoff")).isEqualTo("error");
    assertThat(lastWords(drone)).contains("the fault sensor-error acts");
  }

  @Test
  void aLowBatteryIsReportedAndLandsIt() {
    SteppedDrone drone = flying("low-battery after \"forward\"");
    drone.send("forward 100");
    drone.advance(0.1);

    assertThat(lastReply(drone)).isEqualTo("error Auto land");
    drone.advance(5);
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.GROUNDED);
    assertThat(drone.ask("battery?")).isEqualTo("5\r\n");
    assertThat(drone.ask("takeoff")).isEqualTo("error");
  }

  @Test
  void aHotDroneLandsAndStaysOnTheGround() {
    SteppedDrone drone = flying("overheat 95C at 4s for 60s");
    drone.send("forward 200");
    drone.advance(2);
    assertThat(lastReply(drone)).isEqualTo("error Auto land");
    drone.advance(4);

    assertThat(drone.state().phase()).isEqualTo(FlightPhase.GROUNDED);
    assertThat(drone.ask("temp?")).startsWith("9").endsWith("C\r\n");
    assertThat(drone.ask("takeoff")).isEqualTo("error, high temp");
  }

  @Test
  void motorsThatStopLetItFall() {
    SteppedDrone drone = flying("motor-stop after \"forward\" for 1s");
    drone.send("forward 50");
    drone.advance(3);

    assertThat(lastReply(drone)).isEqualTo("error Motor stop");
    assertThat(drone.state().phase().motorsOn()).isFalse();
    assertThat(words(drone)).contains("falls: the fault motor-stop after \"forward\" for 1s acts");
  }

  @Test
  void aRebootMakesItSilentAndForgetful() {
    SteppedDrone drone = connected("reboot after \"battery?\"");
    drone.send("battery?");
    drone.advance(1);
    int lines = drone.stateLines().size();
    drone.send("command");
    drone.advance(6.5);
    assertThat(drone.stateLines()).hasSize(lines);
    drone.advance(1);

    assertThat(drone.link().sdkMode()).isFalse();
    assertThat(drone.ask("command")).isEqualTo("ok");
    drone.advance(9);
    assertThat(drone.link().sdkMode()).as("once").isTrue();
  }

  @Test
  void aSilentLandingAnswersNobody() {
    SteppedDrone drone = flying("silent-land at 4s for 4s");
    int replies = drone.replies().size();
    drone.advance(5);

    assertThat(drone.state().phase()).isEqualTo(FlightPhase.GROUNDED);
    assertThat(drone.replies()).hasSize(replies);
    assertThat(drone.ask("forward 50")).isEqualTo("error Motor stop");
  }

  @Test
  void aSilentLandingCutsOffWhatRuns() {
    SteppedDrone drone = flying();
    drone.send("forward 200");
    int replies = drone.replies().size();
    drone.control(new Control.InjectFault(Fault.of("silent-land for 5s")));
    drone.advance(6);

    assertThat(drone.replies()).hasSize(replies);
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.GROUNDED);
  }

  @Test
  void aWeakTakeoffEndsLow() {
    SteppedDrone drone = flying("weak-takeoff 15cm");

    assertThat(drone.state().motion().position().z()).isCloseTo(0.15, within(0.02));
  }

  @Test
  void inStationModeTheVideoIsOnAndNothingComes() {
    SteppedDrone drone = connected("no-video-in-station-mode");

    assertThat(drone.ask("streamon")).isEqualTo("ok");
    assertThat(drone.state().video().on()).isTrue();
  }

  @Test
  void aDroneThatIsBlindForPadsSeesNone() {
    SteppedDrone drone =
        SteppedDrone.of(
            config("pad-blind after \"go\"")
                .withArena(Arena.DEFAULT.withPads(List.of(MissionPad.onFloor(1, Vec3.ZERO, 0)))));
    drone.ask("command");
    drone.ask("mon");
    drone.ask("takeoff");
    drone.ask("up 50");
    drone.advance(0.5);
    assertThat(lastLine(drone)).startsWith("mid:1;");
    assertThat(drone.state().perception().padMode()).isNotEqualTo(PadMode.OFF);

    drone.send("go 0 0 60 50 m1");
    drone.advance(0.5);
    assertThat(lastLine(drone)).startsWith("mid:-1;");
  }

  @Test
  void aDistanceSensorThatIsOutHasNoEcho() {
    SteppedDrone drone = connected("tof-out");

    assertThat(drone.ask("tof?")).isEqualTo("65530mm\r\n");
    drone.advance(0.2);
    assertThat(lastLine(drone)).contains(";tof:6553;");
  }

  @Test
  void theBarometerJumps() {
    SteppedDrone drone = connected("baro-jump 300cm after \"sdk?\"");
    double before = Double.parseDouble(drone.ask("baro?").strip());
    drone.ask("sdk?");
    double after = Double.parseDouble(drone.ask("baro?").strip());

    assertThat(after - before).isCloseTo(3, within(1e-5));
  }

  @Test
  void theYawTurnsAwayAndStaysThere() {
    SteppedDrone drone = connected("yaw-drift 2deg/s for 10s");
    drone.advance(15);

    assertThat(Math.abs(drone.state().motion().attitude().heading())).isLessThan(1e-9);
    String yaw = drone.ask("attitude?").replaceFirst("(?s).*yaw:(-?\\d+);.*", "$1");
    assertThat(Math.abs(Integer.parseInt(yaw))).isBetween(19, 21);
  }

  @Test
  void stateLinesThatAreStuckRepeatTheLastOne() {
    SteppedDrone drone = connected("state-stuck at 0s for 5s");
    drone.advance(1);
    drone.ask("takeoff");
    drone.advance(1);

    List<Sent> lines = drone.stateLines();
    String last = lastLine(drone);
    assertThat(lines.subList(lines.size() - 20, lines.size()))
        .extracting(Sent::text)
        .containsOnly(last);
    drone.advance(5);
    assertThat(lastLine(drone)).isNotEqualTo(last);
  }

  @Test
  void stateLinesStopAndGoOn() {
    SteppedDrone drone = connected("state-stopped after \"sdk?\" for 2s");
    drone.ask("sdk?");
    int lines = drone.stateLines().size();
    drone.advance(1.9);
    assertThat(drone.stateLines()).hasSize(lines);
    assertThat(drone.ask("battery?")).isEqualTo("100\r\n");
    drone.advance(1.1);
    assertThat(drone.stateLines()).hasSizeBetween(lines + 9, lines + 11);
  }

  @Test
  void slowStateLinesComeOnceASecond() {
    SteppedDrone drone = connected("state-slow");
    int lines = drone.stateLines().size();
    drone.advance(10);

    assertThat(drone.stateLines()).hasSizeBetween(lines + 9, lines + 11);
  }

  @Test
  void theSameSeedGivesTheSameBytes() {
    assertThat(trace()).isEqualTo(trace());
  }

  private static List<Sent> trace() {
    SteppedDrone drone = flying("dark", "yaw-drift", "loss state 20%", "corrupt state 10%");
    drone.ask("forward 50");
    drone.advance(10);
    drone.ask("land");
    return drone.stateLines();
  }

  private static SteppedDrone flying(String... faults) {
    SteppedDrone drone = connected(faults);
    assertThat(drone.ask("takeoff")).isEqualTo("ok");
    return drone;
  }

  private static SteppedDrone connected(String... faults) {
    SteppedDrone drone = SteppedDrone.of(config(faults));
    assertThat(drone.ask("command")).isEqualTo("ok");
    return drone;
  }

  private static SimConfig config(String... faults) {
    return SimConfig.DEFAULT
        .withLink(LinkPreset.IDEAL)
        .withFaults(List.of(faults).stream().map(Fault::of).toList());
  }

  private static String lastReply(SteppedDrone drone) {
    return drone.replies().get(drone.replies().size() - 1).text();
  }

  private static String lastLine(SteppedDrone drone) {
    return drone.stateLines().get(drone.stateLines().size() - 1).text();
  }

  private static String lastWords(SteppedDrone drone) {
    List<String> words = words(drone);
    return words.get(words.size() - 1);
  }

  private static List<String> words(SteppedDrone drone) {
    return drone.events().stream().map(SimEvent::words).toList();
  }
}
