package tellosimulator.network;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static tellosimulator.testing.SteppedDrone.address;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.math.Vec3;
import tellosimulator.sim.Formation;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.Simulation;
import tellosimulator.world.Room;

class DatagramBatchTest {

  private static final InetSocketAddress ADDRESS = address("127.0.0.1", 8879);

  private final List<String> taken = new ArrayList<>();
  private final Map<Integer, CommandConnection> connections = new TreeMap<>();

  /** Each text is preceded by the number of its drone. */
  @ParameterizedTest
  @CsvSource({
    // a program that waits for each reply
    "'1 up 30, 2 rc 0 0 0 0', '2 rc 0 0 0 0, 1 up 30'",
    "'2 battery?, 1 emergency, 2 x', '1 emergency, 2 battery?, 2 x'",
    "'3 land, 1 rc 9 0 0 0, 2 Re0101 emergency', '1 rc 9 0 0 0, 2 Re0101 emergency, 3 land'",
    "'1 rc 1 0 0 0, 2 up 20, 1 rc 2 0 0 0', '1 rc 1 0 0 0, 1 rc 2 0 0 0, 2 up 20'",
    // nothing is reordered for a single drone
    "'1 up 30, 1 rc 0 0 0 0, 1 emergency', '1 up 30, 1 rc 0 0 0 0, 1 emergency'",
    "'1 up 30, 2 land, 1 rc 0 0 0 0', '1 up 30, 1 rc 0 0 0 0, 2 land'",
    "'1 rcx, 2 emergencies, 3 tof?', '1 rcx, 2 emergencies, 3 tof?'"
  })
  void whatHasNoReplyWasSentBeforeWhatOtherDronesGot(String received, String handedOver) {
    DatagramBatch batch = new DatagramBatch();
    for (String each : received.split(", ", -1)) {
      int drone = Integer.parseInt(each.substring(0, 1));
      batch.add(
          new DatagramBatch.Entry(
              connections.computeIfAbsent(drone, DatagramBatchTest::connection),
              new Peer(ADDRESS, ADDRESS),
              WireText.encode(each.substring(2))));
    }
    Simulation simulation = simulation();
    batch.handOver(simulation);
    simulation.drain();

    assertThat(String.join(", ", taken)).isEqualTo(handedOver);
    assertThat(batch.size()).isZero();
  }

  @Test
  void whatCannotBeTakenIsLostAloneAndNothingIsTakenTwice() {
    DatagramBatch batch = new DatagramBatch();
    int noSuchDrone = 9;
    for (int drone : new int[] {1, noSuchDrone, 2}) {
      batch.add(
          new DatagramBatch.Entry(
              connection(drone), new Peer(ADDRESS, ADDRESS), WireText.encode("x")));
    }
    Simulation simulation = simulation();

    assertThatThrownBy(() -> batch.handOver(simulation))
        .isInstanceOf(IllegalArgumentException.class);
    assertThat(batch.size()).isOne();
    batch.handOver(simulation);
    simulation.drain();

    assertThat(taken).containsExactly("1 x", "2 x");
  }

  private static CommandConnection connection(int drone) {
    return new CommandConnection(
        drone, ADDRESS, new Ports(), (sender, via, bytes, length) -> true, new Traffic());
  }

  private Simulation simulation() {
    SimListener listener =
        new SimListener() {
          @Override
          public void event(SimEvent event) {
            SimEvent.CommandIgnored ignored = (SimEvent.CommandIgnored) event;
            taken.add(ignored.drone() + " " + ignored.text());
          }
        };
    SimConfig config =
        SimConfig.DEFAULT.withRoom(Room.DEFAULT, Formation.row(3, Vec3.ZERO, Room.DEFAULT));
    return new Simulation(config, drone -> datagram -> {}, List.of(listener));
  }
}
