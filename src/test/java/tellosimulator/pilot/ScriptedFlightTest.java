package tellosimulator.pilot;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tellosimulator.headless.HeadlessSimulator;
import tellosimulator.model.FlightPhase;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.Control;
import tellosimulator.sim.LastCommand;
import tellosimulator.sim.SimConfig;
import tellosimulator.testing.HeadlessSimulators;
import tellosimulator.time.TimeFactor;

@Timeout(value = 60, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
final class ScriptedFlightTest {

  private final LastCommand last = new LastCommand();
  private HeadlessSimulator simulator;
  private OnlineSimulation simulation;

  @BeforeEach
  void open() throws Exception {
    simulator = HeadlessSimulators.of(Scenario.of(SimConfig.DEFAULT), AddressPlan.ofMachine(1, 0));
    simulation = simulator.current().simulation();
    simulation.listen(last);
    simulator.switchOn();
    simulation.carryOut(new Control.SetTimeFactor(new TimeFactor(10)));
  }

  @AfterEach
  void close() {
    simulator.close();
  }

  private ScriptedFlight flight(String... commands) throws Exception {
    InetSocketAddress drone = simulation.addresses(1).get(0);
    return new ScriptedFlight(drone, List.of(commands), () -> simulation.time().nanos());
  }

  private void await(FlightPhase phase) {
    while (simulation.snapshot().drones().get(0).state().phase() != phase) {
      Thread.onSpinWait();
    }
  }

  private static void awaitEnd(ScriptedFlight flight) {
    while (!flight.ended()) {
      Thread.onSpinWait();
    }
  }

  @Test
  void eachCommandFollowsTheReplyToTheOneBefore() throws Exception {
    try (ScriptedFlight flight = flight("command", "takeoff", "forward 50", "land")) {
      awaitEnd(flight);

      assertThat(last.newest().orElseThrow().text()).isEqualTo("land");
      await(FlightPhase.GROUNDED);
      double x = simulation.snapshot().drones().get(0).state().motion().position().x();
      assertThat(x).isGreaterThan(0.4);
    }
  }

  @Test
  void aRefusedCommandEndsTheFlightAndLands() throws Exception {
    try (ScriptedFlight flight = flight("command", "takeoff", "forward 9", "up 100")) {
      awaitEnd(flight);
      await(FlightPhase.GROUNDED);

      assertThat(last.newest().orElseThrow().text()).isEqualTo("land");
    }
  }

  @Test
  void closingLandsTheDrone() throws Exception {
    ScriptedFlight flight = flight("command", "takeoff", "forward 100", "back 100");
    await(FlightPhase.FLYING);

    flight.close();

    assertThat(flight.ended()).isTrue();
    await(FlightPhase.GROUNDED);
  }

  @Test
  void sticksOfAnEarlierOperatorAreCentered() throws Exception {
    try (OperatorSocket earlier = OperatorSocket.open(simulation.addresses(1).get(0))) {
      earlier.send("command");
      earlier.send("rc 0 100 0 0");
      try (ScriptedFlight flight = flight("command", "takeoff", "land")) {
        awaitEnd(flight);
      }
    }

    double x = simulation.snapshot().drones().get(0).state().motion().position().x();
    assertThat(x).isBetween(-0.1, 0.1);
  }
}
