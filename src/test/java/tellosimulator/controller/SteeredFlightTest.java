package tellosimulator.controller;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.fault.LinkPreset;
import tellosimulator.math.Vec3;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sim.Formation;
import tellosimulator.sim.SimConfig;
import tellosimulator.testing.SteppedDrone;
import tellosimulator.world.Room;

/** {@code rc} alone, in addition to other commands, and across landings. */
class SteeredFlightTest {

  private static final Room HALL = new Room(100, 100, 12);

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          REPORT  , rc 100 100 0 0  , up 50
          REPORT  , rc 100 100 0 0  , cw 90
          REPORT  , rc 100 100 0 0  , flip f
          REPORT  , rc 0 0 0 100    , forward 100
          REPORT  , rc 0 60 0 60    , forward 100
          MEASURED, rc 0 100 0 0    , up 50
          MEASURED, rc 100 100 0 100, up 50
          """)
  void aMoveUnderTheSticksStillEndsWithOk(Behavior behavior, String rc, String move) {
    SteppedDrone drone = flying(behavior);
    drone.send(rc);
    drone.advance(3);

    assertThat(drone.ask(move)).isEqualTo("ok");
  }

  @ParameterizedTest
  @CsvSource({"REPORT, 1.0", "MEASURED, 1.5"})
  void stopNeverMakesTheDroneFaster(Behavior behavior, double cruise) {
    SteppedDrone drone = flying(behavior);
    drone.send("rc 0 100 0 0");
    drone.advance(5);
    assertThat(speed(drone)).isCloseTo(cruise, within(0.02));

    drone.send("stop");
    double fastest = 0;
    while (!lastReply(drone).equals("forced stop")) {
      drone.advance(0.005);
      fastest = Math.max(fastest, speed(drone));
    }

    assertThat(fastest).isLessThan(cruise + 0.02);
    assertThat(speed(drone)).isLessThan(0.06);
  }

  @Test
  void theEndOfATurnDoesNotDisturbTheSteeredFlight() {
    SteppedDrone drone = flying(Behavior.REPORT);
    drone.send("rc 0 100 0 0");
    drone.advance(5);
    drone.ask("cw 20");

    double fastest = 0;
    for (int i = 0; i < 400; i++) {
      drone.advance(0.005);
      fastest = Math.max(fastest, speed(drone));
    }

    assertThat(fastest).isLessThan(1.05);
  }

  /** The dead time is 0.35 s, the time constant 0.6 s: 0.2 s after lift-off nothing moves yet. */
  @Test
  void valuesSetOnTheGroundActFromLiftOffOnAsIfSetThen() {
    SteppedDrone drone = drone(Behavior.REPORT);
    drone.ask("command");
    drone.send("rc 0 100 0 0");
    drone.advance(5);
    drone.send("takeoff");

    drone.advanceUntil(() -> drone.state().motion().position().z() > 0.001, 3);
    drone.advance(0.2);
    assertThat(drone.state().motion().velocity().horizontal().norm()).isLessThan(0.01);
    drone.advanceUntil(() -> drone.replies().size() > 1, 10);

    assertThat(lastReply(drone)).isEqualTo("ok");
    assertThat(drone.state().motion().velocity().x()).isBetween(0.5, 1.02);
  }

  @Test
  void takeoffWithSticksDownStillTakesOffAndThenSinks() {
    SteppedDrone drone = drone(Behavior.REPORT);
    drone.ask("command");
    drone.send("rc 0 0 -100 0");

    assertThat(drone.ask("takeoff")).isEqualTo("ok");
    assertThat(drone.state().motion().position().z()).isCloseTo(0.30, within(0.02));
    drone.advance(3);
    assertThat(drone.state().motion().position().z()).isCloseTo(0.10, within(0.01));
  }

  @Test
  void forcedStopComesInTimeThoughSticksMoveTheDroneOn() {
    SteppedDrone drone = flying(Behavior.REPORT);
    double sent = drone.seconds();
    drone.send("stop");
    drone.send("rc 0 100 0 0");

    drone.advanceUntil(() -> lastReply(drone).equals("forced stop"), 20);

    assertThat(drone.seconds() - sent).isBetween(0.5, 1.05);
  }

  private static double speed(SteppedDrone drone) {
    return drone.state().motion().velocity().norm();
  }

  private static String lastReply(SteppedDrone drone) {
    return drone.replies().get(drone.replies().size() - 1).text();
  }

  private static SteppedDrone flying(Behavior behavior) {
    SteppedDrone drone = drone(behavior);
    drone.ask("command");
    drone.ask("takeoff");
    drone.ask("up 200");
    return drone;
  }

  private static SteppedDrone drone(Behavior behavior) {
    return SteppedDrone.of(
        SimConfig.DEFAULT
            .withProduct(Profile.EDU, behavior)
            .withLink(LinkPreset.IDEAL)
            .withRoom(HALL, Formation.row(1, Vec3.ZERO, HALL)));
  }
}
