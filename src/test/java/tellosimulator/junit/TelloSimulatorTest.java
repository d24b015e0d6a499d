package tellosimulator.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static tellosimulator.junit.Times.times;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TelloSimulatorTest {

  @Test
  void aFlightIsFlownInNoTimeAndItsTruthIsKnown() throws IOException {
    try (TelloSimulator simulator = TelloSimulator.start()) {
      SimulatedDrone drone = simulator.drone();

      assertThat(
              ScriptedOperator.fly(
                  drone, "command", "takeoff", "up 70", "forward 100", "cw 90", "land"))
          .containsOnly("ok");

      DroneTruth truth = drone.truth();
      assertThat(truth.landed()).isTrue();
      assertThat(truth.position().x()).isCloseTo(100, Offset.offset(1.0));
      assertThat(truth.heading()).isCloseTo(90, Offset.offset(1.0));
      assertThat(truth.highest()).isCloseTo(100, Offset.offset(1.0)); // 30 cm, and 70 cm up
      assertThat(truth.farthest()).isCloseTo(100, Offset.offset(1.0));
      assertThat(truth.touched()).isEmpty();
      assertThat(simulator.simulation().time()).isGreaterThan(Duration.ofSeconds(10));
      assertThat(drone.journal().commands())
          .containsExactly("command", "takeoff", "up 70", "forward 100", "cw 90", "land");
      drone.journal().verify(times(1), "takeoff");
      drone.journal().never("emergency");
    }
  }

  @Test
  void afterAResetTheSameCommandsHaveTheSameEffectsToTheByte() throws IOException {
    try (TelloSimulator simulator = TelloSimulator.builder().behavior("measured").seed(7).start()) {
      List<List<String>> flights = new ArrayList<>();
      List<List<Position>> paths = new ArrayList<>();
      for (int i = 0; i < 3; i++) {
        simulator.reset();
        flights.add(
            ScriptedOperator.fly(
                simulator.drone(), "command", "takeoff", "tof?", "forward 80", "baro?", "land"));
        paths.add(simulator.drone().truth().path());
      }
      assertThat(flights.get(1)).isEqualTo(flights.get(0));
      assertThat(flights.get(2)).isEqualTo(flights.get(0));
      assertThat(paths.get(1)).isEqualTo(paths.get(0));
      assertThat(paths.get(2)).isEqualTo(paths.get(0));
    }
  }

  @Test
  void aResetForgetsEverything() throws IOException {
    try (TelloSimulator simulator = TelloSimulator.start("gate-race")) {
      SimulatedDrone drone = simulator.drone();
      drone.battery(50);
      drone.placeAt(-100, 100, 90);
      ScriptedOperator.fly(drone, "command", "streamon", "takeoff", "forward 500");
      assertThat(drone.truth().position()).isNotEqualTo(drone.truth().start());

      simulator.reset();

      DroneTruth truth = drone.truth();
      assertThat(truth.position()).isEqualTo(new Position(-200, -100, 0));
      assertThat(truth.heading()).isZero();
      assertThat(truth.battery()).isEqualTo(100);
      assertThat(truth.takeoffs()).isZero();
      assertThat(truth.touched()).isEmpty();
      assertThat(truth.path()).containsExactly(truth.position());
      assertThat(drone.journal().entries()).isEmpty();
      assertThat(simulator.simulation().time()).isZero();
      assertThat(simulator.simulation().goals().seconds()).isZero();
      ScriptedOperator.send(drone, "battery?"); // without `command` there is no reply
      JournalEntry entry = drone.journal().await("battery?", Duration.ofSeconds(20));
      assertThat(entry.outcome()).isEqualTo(JournalEntry.Outcome.IGNORED);
    }
  }

  @Test
  void dronesHavePortsOfTheirOwnToWhichStateAndVideoGo() throws IOException {
    try (TelloSimulator simulator = TelloSimulator.builder().drones(3).start()) {
      for (SimulatedDrone drone : simulator.drones()) {
        try (DatagramSocket state =
            new DatagramSocket(drone.statePort(), drone.address().getAddress())) {
          state.setSoTimeout(20_000);
          ScriptedOperator.fly(drone, "command");
          simulator.simulation().advance(Duration.ofSeconds(1));
          DatagramPacket packet = new DatagramPacket(new byte[2048], 2048);
          state.receive(packet);
          assertThat(new String(packet.getData(), StandardCharsets.US_ASCII)).startsWith("mid:");
          assertThat(packet.getPort()).isEqualTo(drone.commandPort());
        }
      }
      assertThat(simulator.drones().stream().map(SimulatedDrone::address).distinct()).hasSize(3);
    }
  }

  @Test
  void simulatedTimePassesOnlyWhenItIsToldToOrSomebodyWaits() {
    try (TelloSimulator simulator = TelloSimulator.start()) {
      TelloSimulation simulation = simulator.simulation();
      simulation.awaitStill();
      Duration before = simulation.time();

      simulation.advance(Duration.ofMinutes(5));

      assertThat(simulation.time().minus(before)).isEqualTo(Duration.ofMinutes(5));
      simulation.awaitStill();
      assertThat(simulation.time().minus(before)).isEqualTo(Duration.ofMinutes(5));
      assertThatIllegalArgumentException()
          .isThrownBy(() -> simulation.advance(Duration.ofSeconds(-1)))
          .withMessage("duration is PT-1S, but must not be negative");
    }
  }

  @Test
  void windBlowsWhereItIsToldTo() {
    try (TelloSimulator simulator = TelloSimulator.start()) {
      simulator.simulation().wind(200, 90);

      assertThat(simulator.snapshot().arena().wind().mean().y()).isCloseTo(-2, Offset.offset(1e-9));
    }
  }

  @Test
  void goalsAreWaitedForAndExplained() throws IOException {
    try (TelloSimulator simulator = TelloSimulator.start("gate-race")) {
      SimulatedDrone drone = simulator.drone();
      assertThatThrownBy(() -> simulator.simulation().awaitGoals(Duration.ofMillis(10)))
          .isInstanceOf(AssertionError.class)
          .hasMessageStartingWith("the goals were not reached within 0.0 s")
          .hasMessageContaining(
              "last command to drone 1: none; did the program start, and does it send to 127.0.0.1:"
                  + drone.commandPort()
                  + "?")
          .hasMessageContaining(
              "drone 1: stands at x -200, y -100, z 0 cm, heading 0 degrees, battery 100 %; never took"
                  + " off")
          .hasMessageContaining("goals: 0 of 4 goals reached; open: 1. fly through gate A");

      ScriptedOperator.fly(drone, "command", "takeoff", "up 70", "forward 200");

      assertThat(drone.truth().visited()).containsExactly("A");
      assertThat(simulator.simulation().goals().done()).containsExactly("1. fly through gate A");
    }
  }

  @Test
  void onlyScenariosWithGoalsCanBeWaitedFor() {
    try (TelloSimulator simulator = TelloSimulator.start()) {
      assertThatThrownBy(() -> simulator.simulation().awaitGoals())
          .isInstanceOf(IllegalStateException.class)
          .hasMessage("the scenario has no goals to wait for");
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          slalon | edu  | report | max  | there is neither a file nor a scenario slalon, did you mean slalom?
          ''     | edo  | report | max  | profile is edo, but must be one of edu, tello, tt, did you mean edu?
          ''     | edu  | meassured | max | behavior is meassured, but must be one of report, measured, did you mean measured?
          ''     | edu  | report | fast | timeFactor is fast, but must be a number such as 5, or max
          ''     | edu  | report | -1   | time factor is -1.0, but must be from 0.01 to 5000.0, or max
          """)
  void nonsenseIsOneSentence(
      String scenario, String profile, String behavior, String factor, String sentence) {
    TelloSimulator.Builder builder =
        TelloSimulator.builder()
            .scenario(scenario)
            .profile(profile)
            .behavior(behavior)
            .timeFactor(factor);

    assertThatIllegalArgumentException().isThrownBy(builder::start).withMessage(sentence);
  }

  @Test
  void thereIsNoDroneThatIsNotThere() {
    try (TelloSimulator simulator = TelloSimulator.start()) {
      assertThatIllegalArgumentException()
          .isThrownBy(() -> simulator.drone(2))
          .withMessage("there is no drone 2, only drone 1");
      assertThatIllegalArgumentException()
          .isThrownBy(() -> simulator.drone().battery(101))
          .withMessage("battery is 101.0 %, but must be from 0 to 100");
      assertThatIllegalArgumentException()
          .isThrownBy(() -> simulator.drone().placeAt(10_000, 0))
          .withMessage("x 10000, y 0 cm is not in the room, where drone 1 should stand");
    }
    assertThatIllegalArgumentException()
        .isThrownBy(() -> TelloSimulator.builder().drones(0))
        .withMessage("drones is 0, but must be at least 1");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> TelloSimulator.builder().scenario("slalom").drones(2).start())
        .withMessage("drones does not go with scenario slalom, which has 1");
  }

  @Test
  void aSimulatorIsClosedOnceAndFreesItsPorts() throws IOException {
    TelloSimulator simulator = TelloSimulator.start();
    SimulatedDrone drone = simulator.drone();
    int port = drone.commandPort();
    simulator.close();

    new DatagramSocket(port, drone.address().getAddress()).close();
    assertThatThrownBy(simulator::close)
        .isInstanceOf(IllegalStateException.class)
        .hasMessage("this simulator was closed already; start another one");
    assertThatThrownBy(() -> drone.battery(50)).isInstanceOf(IllegalStateException.class);
    assertThat(drone.truth().takeoffs()).isZero();
  }
}
