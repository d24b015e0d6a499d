package tellosimulator.controller;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import tellosimulator.fault.LinkPreset;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.FlightPhase;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimEvent;
import tellosimulator.testing.SteppedDrone;
import tellosimulator.world.Arena;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;

/** Obstacles that stop a drone, carry it, or are seen by its sensor. */
class ObstacleFlightTest {

  private static final Room ROOM = new Room(6, 12, 4);

  private static final Obstacle WALL =
      new Obstacle(
          "screen", new Shape.Box(0.02, 2, 2), new Vec3(1.5, 0, 0), 0, ObstacleAppearance.DEFAULT);

  private static final Obstacle TABLE =
      new Obstacle(
          "table", new Shape.Box(1, 1, 0.5), new Vec3(1, 0, 0), 0, ObstacleAppearance.DEFAULT);

  private static final Obstacle GATE =
      new Obstacle(
          "gate", new Shape.Ring(0.5, 0.05, 1), new Vec3(1, 0, 0), 0, ObstacleAppearance.DEFAULT);

  @Test
  void aMoveIntoAnObstacleIsHeldAndAnswersErrorAndTheLogNamesIt() {
    SteppedDrone drone = flying(Behavior.REPORT, WALL);

    assertThat(drone.ask("forward 300")).isEqualTo("error");

    double front = 1.5 - 0.01 - DroneSpec.COLLIDER.radius();
    assertThat(drone.state().motion().position().x()).isCloseTo(front, within(0.01));
    assertThat(words(drone))
        .anyMatch(line -> line.startsWith("touched the obstacle \"screen\" at"))
        .anyMatch(line -> line.contains("failed: it was blocked by the obstacle \"screen\""));
    assertThat(drone.ask("back 50")).isEqualTo("ok");
  }

  @Test
  void aTouchIsToldOnceAndNotAtEachStep() {
    SteppedDrone drone = flying(Behavior.REPORT, WALL);
    drone.send("rc 0 60 0 0");
    drone.advance(8);

    assertThat(words(drone)).filteredOn(line -> line.startsWith("touched")).hasSize(1);
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.FLYING);
  }

  @Test
  void inACornerEachTouchIsToldOnce() {
    SteppedDrone drone = flying(Behavior.REPORT, WALL.movedTo(new Vec3(1.5, 2, 0), 0));
    drone.send("rc -60 60 0 0");
    drone.advance(10);

    assertThat(words(drone))
        .filteredOn(line -> line.startsWith("touched"))
        .satisfiesExactlyInAnyOrder(
            line -> assertThat(line).startsWith("touched the obstacle \"screen\""),
            line -> assertThat(line).startsWith("touched the left wall"));
  }

  @Test
  void aHardHitIsACrash() {
    SteppedDrone drone =
        flying(
            Behavior.MEASURED,
            WALL.movedTo(new Vec3(5, 0, 0), 0),
            WALL.movedTo(new Vec3(5, 0, 2), 0));
    drone.send("rc 0 100 0 0");
    drone.advance(3);

    assertThat(drone.ask("forward 500")).isEqualTo("error Motor stop");

    assertThat(drone.state().phase()).isEqualTo(FlightPhase.CRASHED);
    assertThat(words(drone))
        .anyMatch(line -> line.startsWith("crashed into the obstacle \"screen\""));
    drone.advance(2);
    assertThat(drone.state().motion().position().z()).isZero();
    assertThat(drone.state().motion().position().x()).isLessThan(5);
  }

  @Test
  void aDroneFliesThroughAGate() {
    SteppedDrone drone = flying(Behavior.REPORT, GATE);

    assertThat(drone.ask("up 70")).isEqualTo("ok");
    assertThat(drone.ask("forward 200")).isEqualTo("ok");

    assertThat(words(drone)).noneMatch(line -> line.startsWith("touched"));
  }

  @Test
  void theDistanceSensorSeesWhatIsBelowAndHeightDoesNot() {
    SteppedDrone drone = flying(Behavior.REPORT, TABLE);
    drone.ask("up 70");
    assertThat(drone.ask("battery?")).isEqualTo("100\r\n");

    assertThat(line(drone)).contains("tof:100;h:100;");
    drone.ask("forward 100");

    drone.advance(0.2);
    assertThat(line(drone)).as("the table is 50 cm high").contains("tof:50;h:100;");
  }

  @Test
  void aDroneLandsOnATableAndTakesOffFromIt() {
    SteppedDrone drone = flying(Behavior.REPORT, TABLE);
    drone.ask("up 70");
    drone.ask("forward 100");

    assertThat(drone.ask("land")).isEqualTo("ok");
    assertThat(drone.state().motion().position().z()).isCloseTo(0.5, within(1e-6));
    assertThat(words(drone)).contains("landed on \"table\"");
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.GROUNDED);
    assertThat(drone.ask("takeoff")).isEqualTo("ok");
    assertThat(drone.state().motion().position().z()).isCloseTo(0.8, within(0.01));
  }

  @Test
  void heightCountsFromThePlaceOfTheLastTakeoff() {
    SteppedDrone drone = flying(Behavior.REPORT, TABLE);
    drone.ask("up 70");
    drone.ask("forward 100");
    drone.ask("land");
    assertThat(drone.ask("height?")).as("still from the floor").isEqualTo("5dm\r\n");

    drone.ask("takeoff");

    drone.advance(0.2);
    assertThat(line(drone)).as("30 cm above the table").contains("tof:30;h:30;");
    assertThat(drone.ask("height?")).isEqualTo("3dm\r\n");
    drone.ask("back 100");
    drone.advance(0.2);
    assertThat(line(drone)).as("80 cm above the floor").contains("tof:80;h:30;");
    drone.ask("land");
    assertThat(drone.ask("height?")).as("50 cm below the table").isEqualTo("-5dm\r\n");
    drone.control(new Control.Reset(1));
    assertThat(drone.ask("height?")).isEqualTo("0dm\r\n");
  }

  @Test
  void aDroneWhoseTableIsTakenAwayFalls() {
    SteppedDrone drone = flying(Behavior.REPORT, TABLE);
    drone.ask("up 70");
    drone.ask("forward 100");
    drone.ask("land");

    drone.control(new Control.Furnish(List.of(), List.of()));
    drone.advance(1);

    assertThat(drone.state().motion().position().z()).isZero();
    assertThat(drone.ask("takeoff")).isEqualTo("ok");
  }

  @Test
  void aDroneInWhichSomethingIsPutIsPushedOut() {
    SteppedDrone drone = flying(Behavior.REPORT);
    drone.ask("land");

    drone.control(new Control.Furnish(List.of(TABLE.movedTo(new Vec3(0.45, 0, 0), 0)), List.of()));
    drone.advance(1);

    // the table begins at x = -0.05, and the drone leaves it by the shortest way
    assertThat(drone.state().motion().position().x())
        .isCloseTo(-0.05 - DroneSpec.COLLIDER.radius(), within(0.001));
    assertThat(drone.ask("takeoff")).isEqualTo("ok");
  }

  @Test
  void aDroneIsNotPutBackIntoAnObstacle() {
    SteppedDrone drone = flying(Behavior.REPORT, TABLE);
    drone.ask("land");
    drone.control(new Control.SetStart(1, new Vec3(0.55, 0, 0)));
    drone.advance(1);
    assertThat(drone.state().motion().position().x())
        .isCloseTo(0.5 - DroneSpec.COLLIDER.radius(), within(0.001));

    drone.ask("takeoff");
    drone.control(new Control.Reset(1));
    drone.advance(1);

    assertThat(drone.state().motion().position().x())
        .isCloseTo(0.5 - DroneSpec.COLLIDER.radius(), within(0.001));
    assertThat(drone.state().motion().position().z()).isZero();
    assertThat(drone.ask("takeoff")).isEqualTo("ok");
  }

  private static SteppedDrone flying(Behavior behavior, Obstacle... obstacles) {
    SteppedDrone drone =
        SteppedDrone.of(
            SimConfig.DEFAULT
                .withProduct(Profile.EDU, behavior)
                .withLink(LinkPreset.IDEAL)
                .withArena(Arena.DEFAULT.withRoom(ROOM).withObstacles(List.of(obstacles))));
    assertThat(drone.ask("command")).isEqualTo("ok");
    assertThat(drone.ask("takeoff")).isEqualTo("ok");
    return drone;
  }

  private static String line(SteppedDrone drone) {
    return drone.stateLines().get(drone.stateLines().size() - 1).text();
  }

  private static List<String> words(SteppedDrone drone) {
    return drone.events().stream().map(SimEvent::words).toList();
  }
}
