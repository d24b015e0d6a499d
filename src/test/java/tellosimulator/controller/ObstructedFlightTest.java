package tellosimulator.controller;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.fault.Fault;
import tellosimulator.fault.LinkPreset;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.FlightPhase;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sim.Control;
import tellosimulator.sim.Formation;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimEvent;
import tellosimulator.testing.SteppedDrone;
import tellosimulator.world.Room;

/** Collisions with walls, floor and ceiling, which stop a drone or end its flight. */
class ObstructedFlightTest {

  @Test
  void aMoveIntoAWallIsHeldForASecondAndAnswersError() {
    SteppedDrone drone = flying(Behavior.REPORT, Room.DEFAULT);

    String reply = drone.ask("forward 300");

    assertThat(reply).isEqualTo("error");
    double wall = Room.DEFAULT.depth() / 2 - DroneSpec.COLLIDER.radius();
    assertThat(drone.state().motion().position().x()).isCloseTo(wall, within(0.01));
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.FLYING);
    assertThat(lastWords(drone)).contains("`forward 300` failed: it was blocked by the front wall");
    assertThat(drone.ask("back 50")).isEqualTo("ok");
  }

  @Test
  void aClimbStopsAtTheCeiling() {
    SteppedDrone drone = flying(Behavior.REPORT, Room.DEFAULT);

    assertThat(drone.ask("up 400")).isEqualTo("error");

    double ceiling = Room.DEFAULT.height() - DroneSpec.COLLIDER.height();
    assertThat(drone.state().motion().position().z()).isCloseTo(ceiling, within(0.01));
  }

  /** {@code rc} 100 is 1.5 m/s here, and a simultaneous move adds up to 1 m/s. */
  @Test
  void aHardHitIsACrashUntilReset() {
    SteppedDrone drone = flying(Behavior.MEASURED, new Room(30, 30, 10));
    drone.send("rc 0 100 0 0");
    drone.advance(4);

    assertThat(drone.ask("forward 500")).isEqualTo("error Motor stop");
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.CRASHED);
    assertThat(lastWords(drone)).contains("crashed into the front wall at");

    drone.advance(2);
    assertThat(drone.state().motion().position().z()).as("fallen").isZero();
    assertThat(drone.ask("forward 50")).isEqualTo("error Motor stop");
    assertThat(drone.ask("takeoff")).isEqualTo("error Motor stop");

    drone.control(new Control.Reset(1));
    assertThat(drone.state().motion().position()).isEqualTo(Vec3.ZERO);
    assertThat(drone.ask("takeoff")).isEqualTo("ok");
  }

  /** {@code rc} 100 is 1.0 m/s in behaviour {@code report}, and a crash is faster than 1.35 m/s. */
  @Test
  void atFullStickOfTheReportItIsATouch() {
    SteppedDrone drone = flying(Behavior.REPORT, new Room(30, 5, 3));
    drone.send("rc 0 100 0 0");
    drone.advance(8);

    assertThat(drone.state().phase()).isEqualTo(FlightPhase.FLYING);
    assertThat(words(drone)).contains("touched the front wall at 1.0 m/s");
  }

  /**
   * {@code rc} 100 is 1.5 m/s in behaviour {@code measured}; after 2.4 m it is faster than 1.35
   * m/s.
   */
  @Test
  void atFullStickOfTheMeasurementsItIsACrash() {
    SteppedDrone drone = flying(Behavior.MEASURED, Room.DEFAULT);
    drone.send("rc 0 100 0 0");
    drone.advance(8);

    assertThat(drone.state().phase()).isEqualTo(FlightPhase.CRASHED);
    assertThat(drone.ask("takeoff")).isEqualTo("error Motor stop");
  }

  @ParameterizedTest
  @ValueSource(strings = {"forward 300", "forward 500", "go 500 0 0 100", "up 500"})
  void aMoveAtTheUsualSpeedIntoAWallIsATouch(String move) {
    SteppedDrone drone = flying(Behavior.REPORT, Room.DEFAULT);

    assertThat(drone.ask(move)).isEqualTo("error");
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.FLYING);
  }

  @Test
  void aConfigurationSaysHowFastATouchMayBe() {
    SimConfig config = SimConfig.DEFAULT.withCrashSpeed(0.3);
    SteppedDrone drone = flying(config);

    assertThat(drone.ask("forward 300")).isEqualTo("error Motor stop");
    assertThat(lastFlight(drone)).startsWith("crashed into the front wall at 0.8 m/s");

    SteppedDrone robust =
        flying(
            config
                .withProduct(Profile.EDU, Behavior.MEASURED)
                .withLink(LinkPreset.IDEAL)
                .withCrashSpeed(20));
    robust.send("rc 0 100 0 0");
    robust.advance(8);
    assertThat(robust.state().phase()).isEqualTo(FlightPhase.FLYING);
    robust.send("emergency");
    robust.advance(3);
    assertThat(robust.state().phase()).isEqualTo(FlightPhase.GROUNDED);
  }

  @Test
  void aDeepFallIsACrashAndItsHeightAndSpeedAreTold() {
    SteppedDrone drone = flying(Behavior.REPORT, new Room(5, 5, 5));
    drone.ask("up 350");
    int replies = drone.replies().size();
    double height = drone.state().motion().position().z();

    drone.send("emergency");
    // Free fall from 3.8 m takes the root of 2 · 3.8 / 9.81, 0.88 s; drag adds a little.
    drone.advance(0.4);
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.FALLING);
    double fallen = height - drone.state().motion().position().z();
    assertThat(fallen).as("half of 9.81 · 0.4²").isCloseTo(0.785, within(0.06));
    drone.advance(0.8);

    assertThat(drone.state().phase()).isEqualTo(FlightPhase.CRASHED);
    assertThat(drone.replies()).as("no reply to emergency").hasSize(replies);
    assertThat(words(drone)).doesNotContain("landed");
    // The root of 2 · 3.8 · 9.81 is 8.6 m/s; drag takes about a seventh of it.
    assertThat(lastFlight(drone))
        .matches("crashed into the floor at 7[.][0-9] m/s after a fall of 3[.]8 m; its motors .*");
    assertThat(drone.ask("takeoff")).isEqualTo("error Motor stop");
  }

  @Test
  void emergencyDropsTheDroneWithoutHarm() {
    SteppedDrone drone = flying(Behavior.REPORT, Room.DEFAULT);
    drone.ask("up 50");

    drone.send("emergency");
    drone.advance(1);

    assertThat(drone.state().phase()).isEqualTo(FlightPhase.GROUNDED);
    assertThat(words(drone)).doesNotContain("landed");
    // The root of 2 · 0.8 · 9.81 is 4.0 m/s; drag takes about a tenth of it.
    assertThat(lastFlight(drone)).matches("fell 0[.]8 m and hit the floor at 3[.][5-9] m/s");
    assertThat(drone.ask("takeoff")).isEqualTo("ok");
  }

  @Test
  void aContactIsToldAtItsBeginningAndAtItsEnd() {
    SteppedDrone drone = flying(Behavior.REPORT, Room.DEFAULT);
    drone.ask("forward 300");
    for (int i = 0; i < 4; i++) {
      drone.advance(10);
      drone.ask("battery?");
    }
    assertThat(words(drone)).filteredOn(line -> line.contains("touch")).hasSize(1);

    drone.ask("back 50");

    assertThat(words(drone))
        .filteredOn(line -> line.contains("touch"))
        .satisfiesExactly(
            line -> assertThat(line).startsWith("touched the front wall at"),
            line ->
                assertThat(line)
                    .matches("does not touch the front wall any more, after 4.[.][0-9] s"));
  }

  @Test
  void withTheFlightItsContactsEnd() {
    SteppedDrone drone = flying(Behavior.REPORT, Room.DEFAULT);
    drone.ask("forward 300");

    drone.ask("land");

    assertThat(words(drone))
        .filteredOn(line -> line.contains("touch") || line.equals("landed"))
        .satisfiesExactly(
            line -> assertThat(line).startsWith("touched the front wall at"),
            line -> assertThat(line).startsWith("does not touch the front wall any more"),
            line -> assertThat(line).isEqualTo("landed"));
  }

  @Test
  void takeoffIsRefusedWhileTheDroneStillFalls() {
    SteppedDrone drone = flying(Behavior.REPORT, Room.DEFAULT);
    drone.ask("up 200");

    drone.send("emergency");
    drone.advance(0.1);

    assertThat(drone.ask("takeoff")).isEqualTo("error");
  }

  @Test
  void aSoftTouchLetsTheDroneSlideAlongTheWall() {
    SteppedDrone drone = flying(Behavior.REPORT, Room.DEFAULT);
    drone.send("rc 40 60 0 0");

    drone.advance(6);

    Vec3 position = drone.state().motion().position();
    double wall = Room.DEFAULT.depth() / 2 - DroneSpec.COLLIDER.radius();
    assertThat(position.x()).isCloseTo(wall, within(0.01));
    assertThat(position.y()).as("to the right").isLessThan(-1);
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.FLYING);
  }

  /**
   * The movement commanded by the sticks decays over seconds, and does not block a move at the
   * wall.
   */
  @ParameterizedTest
  @CsvSource({
    "rc 0 100 0 0, up 30, 0",
    "rc 0 100 0 0, up 30, 0.5",
    "rc 0 100 0 0, up 30, 1",
    "rc 0 100 0 0, up 100, 1",
    "rc 0 100 0 0, left 30, 1",
    "rc 0 100 0 0, cw 90, 1",
    "rc 0 100 0 0, back 50, 1",
    "rc 0 100 0 0, go 0 40 40 100, 1",
    "rc 0 100 0 0, land, 1",
    "rc 100 0 0 0, up 30, 1",
    "rc 100 100 0 0, up 30, 1",
    "rc 100 100 0 0, up 100, 1"
  })
  void aMoveAlongAWallAfterSticksIntoItIsFlown(String sticks, String move, double pause) {
    SteppedDrone drone = flying(Behavior.REPORT, Room.DEFAULT);
    drone.ask("up 60");
    drone.send(sticks);
    drone.advance(6);
    drone.send("rc 0 0 0 0");
    drone.advance(pause);

    assertThat(drone.ask(move)).isEqualTo("ok");
    if (move.startsWith("up")) {
      double height = 0.9 + Double.parseDouble(move.substring(3)) / 100;
      assertThat(drone.state().motion().position().z()).isCloseTo(height, within(0.01));
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"up 100", "right 100", "cw 180", "land"})
  void sticksIntoAWallDuringAMoveAlongItLeaveItsAnswer(String move) {
    SteppedDrone drone = flying(Behavior.MEASURED, Room.DEFAULT);
    drone.ask("up 60");
    drone.send("rc 0 40 0 0");
    drone.advance(6);

    assertThat(drone.ask(move)).isEqualTo("ok");
  }

  /** In behaviour {@code measured}, a move ends up to 7.5 cm away from its goal. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
  void aMoveAlongAWallThatMissesIntoItIsFlown(long seed) {
    SteppedDrone drone =
        flying(
            SimConfig.DEFAULT
                .withProduct(Profile.EDU, Behavior.MEASURED)
                .withLink(LinkPreset.IDEAL)
                .withSeed(seed));
    assertThat(drone.ask("forward 300")).isEqualTo("error");

    for (String move : List.of("up 60", "right 60", "left 60", "cw 90", "down 40")) {
      assertThat(drone.ask(move)).as(move).isEqualTo("ok");
    }
  }

  @Test
  void aDriftIntoAWallLeavesTheAnswerOfALanding() {
    SteppedDrone drone = flying(Behavior.REPORT, new Room(1, 1, 3));
    drone.control(new Control.InjectFault(Fault.of("no-valid-imu 50cm/s")));
    drone.advance(5);

    assertThat(drone.ask("land")).isEqualTo("ok");
  }

  @Test
  void aSmallerRoomNeverLeavesADroneOutside() {
    SteppedDrone drone = flying(Behavior.REPORT, Room.DEFAULT);
    drone.ask("forward 200");
    Room small = new Room(2, 2, 2);

    drone.control(new Control.SetRoom(small));

    assertThat(small.contains(drone.state().motion().position(), DroneSpec.COLLIDER)).isTrue();
    assertThat(drone.ask("up 50")).isEqualTo("ok");
  }

  private static SteppedDrone flying(Behavior behavior, Room room) {
    return flying(
        SimConfig.DEFAULT
            .withProduct(Profile.EDU, behavior)
            .withLink(LinkPreset.IDEAL)
            .withRoom(room, Formation.row(1, Vec3.ZERO, room)));
  }

  private static SteppedDrone flying(SimConfig config) {
    SteppedDrone drone = SteppedDrone.of(config);
    assertThat(drone.ask("command")).isEqualTo("ok");
    assertThat(drone.ask("takeoff")).isEqualTo("ok");
    return drone;
  }

  private static List<String> words(SteppedDrone drone) {
    return drone.events().stream().map(SimEvent::words).toList();
  }

  /** Returns the last flight event of the drone. */
  private static String lastFlight(SteppedDrone drone) {
    List<String> flight =
        drone.events().stream()
            .filter(SimEvent.DroneFlight.class::isInstance)
            .map(SimEvent::words)
            .toList();
    return flight.get(flight.size() - 1);
  }

  private static String lastWords(SteppedDrone drone) {
    SimEvent last = drone.events().get(drone.events().size() - 1);
    return last.words();
  }
}
