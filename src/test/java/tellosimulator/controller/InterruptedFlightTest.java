package tellosimulator.controller;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import tellosimulator.controller.FlightEvent.Fell;
import tellosimulator.controller.FlightEvent.TookOff;
import tellosimulator.model.FlightPhase;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimEvent;
import tellosimulator.testing.SteppedDrone;
import tellosimulator.world.Room;

/** Stops, restarts and power switches at awkward moments. */
class InterruptedFlightTest {

  @Test
  void whoHasLandedByItselfSaysSoAndWhere() {
    SteppedDrone drone = SteppedDrone.of(Profile.EDU, Behavior.REPORT);
    assertThat(drone.ask("command")).isEqualTo("ok");
    assertThat(drone.ask("forward 50")).isEqualTo("error Motor stop");
    assertThat(last(drone)).contains("refused: the drone does not fly, send `takeoff` first");

    drone.ask("takeoff");
    drone.ask("forward 50");
    drone.advance(20);

    assertThat(drone.ask("forward 50")).isEqualTo("error Motor stop");
    assertThat(last(drone))
        .contains(
            "refused: the drone landed by itself at x 50, y 0 (no command came for 15 s), send"
                + " `takeoff` first");
  }

  private static String last(SteppedDrone drone) {
    return drone.events().get(drone.events().size() - 1).words();
  }

  private final SteppedDrone drone = SteppedDrone.of(Profile.EDU, Behavior.REPORT);

  @Test
  void stopBeforeLiftOffIsRefusedAndTheTakeoffGoesOn() {
    drone.ask("command");
    drone.send("takeoff");
    drone.advance(0.3);

    assertThat(drone.ask("stop")).isEqualTo("error");
    assertThat(drone.state().motion().position().z()).isZero();
    drone.advance(4);
    assertThat(drone.replies().get(drone.replies().size() - 1).text()).isEqualTo("ok");
    assertThat(drone.state().motion().position().z()).isCloseTo(0.30, within(0.01));
  }

  @Test
  void stopAfterTouchdownIsRefusedAndTheLandingEnds() {
    flying(drone);
    drone.send("land");
    drone.advanceUntil(() -> drone.state().motion().position().z() == 0, 5);
    drone.advance(0.15);

    assertThat(drone.ask("stop")).isEqualTo("error");
    drone.advance(1);
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.GROUNDED);
    assertThat(drone.replies().get(drone.replies().size() - 1).text()).isEqualTo("ok");
  }

  @Test
  void takingOffIsToldWhenTheDroneLeavesTheGround() {
    drone.ask("command");
    drone.send("takeoff");
    drone.advance(0.5);
    assertThat(happened(TookOff.class)).isFalse();

    drone.advance(0.5);
    assertThat(happened(TookOff.class)).isTrue();
  }

  @Test
  void emergencyBeforeLiftOffIsNoFall() {
    drone.ask("command");
    drone.send("takeoff");
    drone.advance(0.3);
    drone.send("emergency");
    drone.advance(1);

    assertThat(drone.state().phase()).isEqualTo(FlightPhase.GROUNDED);
    assertThat(happened(Fell.class)).isFalse();
    assertThat(happened(TookOff.class)).isFalse();
  }

  /** A fall from 3.3 m hits the floor at the square root of 2 · 9.81 · 3.3, 8 m/s without drag. */
  @Test
  void switchingOnOnTheWayDownDoesNotSoftenTheFall() {
    SteppedDrone high =
        SteppedDrone.of(SimConfig.DEFAULT.withRoom(new Room(5, 5, 5), SimConfig.DEFAULT.starts()));
    flying(high);
    high.ask("up 300");
    high.control(new Control.Power(1, false));
    high.advanceUntil(() -> high.state().motion().position().z() < 1, 3);
    high.control(new Control.Power(1, true));
    high.advance(1);

    assertThat(high.state().phase()).isEqualTo(FlightPhase.CRASHED);
  }

  @Test
  void switchingOffDuringARestartKeepsTheDroneOff() {
    SteppedDrone tt = SteppedDrone.of(Profile.TT, Behavior.REPORT);
    tt.ask("command");
    tt.send("reboot");
    tt.advance(1);
    tt.control(new Control.Power(1, false));

    tt.advance(10);

    assertThat(tt.state().phase()).isEqualTo(FlightPhase.OFF);
  }

  @Test
  void aSecondRestartDoesNotPostponeTheFirst() {
    SteppedDrone measured = SteppedDrone.of(Profile.EDU, Behavior.MEASURED);
    measured.ask("command");
    for (int i = 0; i < 3; i++) {
      measured.send("ap school secret");
      measured.advance(1.1);
    }

    assertThat(measured.state().phase()).isEqualTo(FlightPhase.OFF);
  }

  @Test
  void aLandingIsNotCutOffByASecondOne() {
    SteppedDrone measured = SteppedDrone.of(Profile.EDU, Behavior.MEASURED);
    flying(measured);
    measured.send("land");
    measured.advance(1);

    assertThat(measured.ask("land")).isEqualTo("error Not joystick");
    measured.advance(4);
    assertThat(measured.replies().get(measured.replies().size() - 1).text()).isEqualTo("ok");
    assertThat(measured.state().phase()).isEqualTo(FlightPhase.GROUNDED);
  }

  @Test
  void aDroneThatWaitsJustInsideAWallTakesCommands() {
    flying(drone);
    drone.ask("up 50");

    for (double distance = 240; distance <= 243.5; distance += 0.5) {
      drone.ask("forward " + distance);
      assertThat(drone.ask("cw 90")).as("after forward %s", distance).isEqualTo("ok");
      assertThat(drone.ask("ccw 90")).isEqualTo("ok");
      assertThat(drone.ask("land")).isEqualTo("ok");
      drone.control(new Control.Reset(1));
      drone.ask("takeoff");
      drone.ask("up 50");
    }
  }

  private static void flying(SteppedDrone drone) {
    drone.ask("command");
    drone.ask("takeoff");
  }

  private boolean happened(Class<? extends FlightEvent> kind) {
    return drone.events().stream()
        .anyMatch(
            event ->
                event instanceof SimEvent.DroneFlight flight && kind.isInstance(flight.event()));
  }
}
