package tellosimulator.proxy;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.comparison.FlightComparison;
import tellosimulator.comparison.FlightComparison.Flight;
import tellosimulator.comparison.Tolerance;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.GoalWatch;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.recording.DroneRecorder;
import tellosimulator.recording.FlightRecorder;
import tellosimulator.recording.FlightRecorder.Subject;
import tellosimulator.recording.RecordingFiles;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.sim.SimConfig.StreamPorts;

/** Tests a simulator in place of the drone, in real time. */
@Tag("slow")
class ProxiedSimulatorTest {

  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();

  /** On a busy machine, a flight in real time stalls occasionally; its distances do not change. */
  private static final Tolerance ANY_DURATION =
      new Tolerance(
          Tolerance.DEFAULT.share(),
          Double.POSITIVE_INFINITY,
          Tolerance.DEFAULT.centimeters(),
          Tolerance.DEFAULT.degrees());

  @TempDir private Path folder;

  @Test
  @Timeout(value = 180, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
  void theProxysRecordingIsLikeTheSimulatorsOwn() throws Exception {
    Path own = folder.resolve("own");
    Path passed = folder.resolve("passed");
    GoalWatch goals = new GoalWatch(Challenge.NONE, news -> {});
    Scenario scenario = Scenario.of(SimConfig.DEFAULT);
    try (WireEnd operator = WireEnd.loopback();
        WireEnd states = WireEnd.loopback();
        FlightRecorder recorder =
            FlightRecorder.start(
                RecordingFolder.at(own), new Subject("", scenario, List.of(), goals), told -> {});
        OnlineSimulation simulation =
            new OnlineSimulation(
                scenario.config(),
                AddressPlan.portPerDrone(1, List.of(LOOPBACK), 0),
                OptionalInt.empty(),
                List.of())) {
      recorder.attach(simulation);
      simulation.switchAllOn();
      InetSocketAddress drone = simulation.addresses(1).get(0);
      try (DroneProxy proxy = proxy(drone, states, passed)) {
        simulation.carryOut(new Control.Power(1, false));
        simulation.carryOut(new Control.Configure(1, Product.DEFAULT, proxy.streamPorts()));
        simulation.carryOut(new Control.Power(1, true));
        for (String command :
            List.of("command", "battery?", "takeoff", "forward 50", "cw 90", "up 9", "land")) {
          operator.send(command, proxy.addresses().get(0));
          assertThat(operator.receive()).isNotEmpty();
        }
        assertThat(states.receive()).startsWith("mid:");
      }
    }

    FlightComparison comparison = FlightComparison.of(flight(own), flight(passed), ANY_DURATION);
    assertThat(comparison.pairs()).hasSize(7).allMatch(pair -> pair.differing().isEmpty());
    assertThat(comparison.pairs().get(3).second().orElseThrow().motion().orElseThrow().forward())
        .isBetween(30.0, 70.0);
  }

  private static DroneProxy proxy(InetSocketAddress drone, WireEnd states, Path recordings)
      throws IOException {
    return DroneProxy.start(
        new ProxyPlan(
            drone,
            AddressPlan.portPerDrone(1, List.of(LOOPBACK), 0),
            new StreamPorts(0, 0),
            new StreamPorts(states.port(), 9)),
        DroneRecorder.start(RecordingFolder.at(recordings), LOOPBACK, List.of(), reason -> {}));
  }

  private static Flight flight(Path parent) throws Exception {
    return Flight.read(RecordingFiles.only(parent).folder());
  }
}
