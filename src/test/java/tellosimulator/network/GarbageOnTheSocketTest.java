package tellosimulator.network;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.testing.SteppedDrone.address;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.ConcurrentLinkedDeque;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tellosimulator.command.GarbageSource;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.Simulation;
import tellosimulator.sim.SimulationLoop;
import tellosimulator.time.TimeFactor;

/**
 * Sends arbitrary datagrams to the command socket, from several peers at once: the drone still
 * flies.
 */
class GarbageOnTheSocketTest {

  private static final int PEERS = 4;
  private static final int DATAGRAMS_OF_A_PEER = 30_000;
  private static final int DATAGRAMS_OF_A_SOCKET = 5000;
  private static final int BURST = 50;

  /** The largest datagram that IPv4 carries: 65,535 bytes less the headers of IP and UDP. */
  private static final int LARGEST = 65_507;

  private static final int LAST_EVENTS = 40;

  private final AtomicInteger heard = new AtomicInteger();
  private final Deque<String> lastEvents = new ConcurrentLinkedDeque<>();
  private final SimListener counter =
      new SimListener() {
        @Override
        public void event(SimEvent event) {
          lastEvents.add(event.time().seconds() + " s: " + event.words());
          if (lastEvents.size() > LAST_EVENTS) {
            lastEvents.remove();
          }
          if (event instanceof SimEvent.CommandReceived
              || event instanceof SimEvent.CommandIgnored) {
            heard.incrementAndGet();
          }
        }
      };

  @Test
  @Timeout(value = 120, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
  void afterAHundredThousandDatagramsOfGarbageTheDroneStillFlies() throws Exception {
    Set<Thread> before = Thread.getAllStackTraces().keySet();
    try (DroneNetwork network =
            OpenNetwork.of(AddressPlan.of(List.of(address("127.0.0.1", 0).getAddress()), 0));
        DatagramSocket states = new DatagramSocket(address("127.0.0.1", 0))) {
      Simulation simulation = simulation(network, states.getLocalPort());
      try (SimulationLoop loop = new SimulationLoop(simulation)) {
        assertThat(loop).isNotNull();
        network.listen(simulation);
        InetSocketAddress drone = network.addresses().get(0).get(0);

        garbageFromAllPeers(drone);

        // The kernel drops datagrams when the socket buffer is full; most must have arrived.
        // Datagrams that do not even begin like a command are rejected beyond a few hundred a
        // second.
        assertThat(network.traffic(1).received()).isGreaterThan(PEERS * DATAGRAMS_OF_A_PEER / 2);
        assertThat(heard.get()).isGreaterThan(PEERS * DATAGRAMS_OF_A_PEER / 6);
        assertThat(namesOfNewThreads(before)).contains("sim", "receiver");
        fly(simulation, drone);
        assertThat(namesOfNewThreads(before)).contains("sim", "receiver");
      }
    }
  }

  private void garbageFromAllPeers(InetSocketAddress drone) throws Exception {
    ExecutorService peers = Executors.newFixedThreadPool(PEERS);
    try {
      List<Future<Integer>> sent = new ArrayList<>();
      for (int i = 0; i < PEERS; i++) {
        long seed = i;
        sent.add(peers.submit(() -> garbage(seed, drone)));
      }
      int all = 0;
      for (Future<Integer> peer : sent) {
        all += peer.get();
      }
      assertThat(all).isGreaterThanOrEqualTo(100_000);
    } finally {
      peers.shutdownNow();
    }
  }

  /**
   * Sends garbage from one peer after another. Each closes after some thousand datagrams, before
   * its replies arrive.
   */
  private static int garbage(long seed, InetSocketAddress drone) throws IOException {
    GarbageSource garbage = new GarbageSource(seed);
    int sent = 0;
    while (sent < DATAGRAMS_OF_A_PEER) {
      try (DatagramSocket socket = new DatagramSocket(address("127.0.0.1", 0))) {
        socket.setSoTimeout(100);
        send(socket, drone, "command");
        for (int i = 1; i <= DATAGRAMS_OF_A_SOCKET; i++) {
          byte[] bytes = bytes(garbage, i);
          socket.send(new DatagramPacket(bytes, bytes.length, drone));
          sent++;
          if (i % BURST == 0 && i < DATAGRAMS_OF_A_SOCKET) {
            awaitEcho(socket, drone, "battery? probe " + sent);
          }
        }
      }
    }
    return sent;
  }

  /**
   * Waits until the drone has caught up, so that the kernel drops little; continues if the probe is
   * lost.
   */
  private static void awaitEcho(DatagramSocket socket, InetSocketAddress drone, String probe)
      throws IOException {
    send(socket, drone, probe);
    try {
      while (!receive(socket).equals("unknown command: " + probe)) {
        // the replies before it are those to the garbage
      }
    } catch (SocketTimeoutException e) {
      return;
    }
  }

  private static byte[] bytes(GarbageSource garbage, int number) {
    return switch (number % 1000) {
      case 0 -> new byte[LARGEST];
      case 1 -> new byte[0];
      case 2 -> "x".repeat(60_000).getBytes(StandardCharsets.ISO_8859_1);
      default -> garbage.next().getBytes(StandardCharsets.ISO_8859_1);
    };
  }

  /** Recovers as a user would: back to the start, then a flight. */
  private void fly(Simulation simulation, InetSocketAddress drone) throws IOException {
    try (DatagramSocket operator = new DatagramSocket(address("127.0.0.1", 0))) {
      operator.connect(drone); // ignores late replies to the previous owner of its port
      operator.setSoTimeout(20_000);
      awaitAnswer(operator, drone);
      simulation.control(new Control.Reset(1));
      simulation.control(new Control.SetBattery(1, 100));
      assertThat(ask(operator, drone, "command")).isEqualTo("ok");
      assertThat(ask(operator, drone, "rc 0 0 0 0; speed")).startsWith("unknown command: ");
      assertThat(ask(operator, drone, "speed 100")).isEqualTo("ok");
      assertThat(ask(operator, drone, "takeoff")).as(this::lastEvents).isEqualTo("ok");
      double x = simulation.snapshot().drones().get(0).state().motion().position().x();
      assertThat(ask(operator, drone, "forward 50")).isEqualTo("ok");
      double flown = simulation.snapshot().drones().get(0).state().motion().position().x() - x;
      assertThat(flown).isBetween(0.48, 0.52);
      assertThat(ask(operator, drone, "land")).isEqualTo("ok");
    }
  }

  private String lastEvents() {
    return String.join("\n", lastEvents);
  }

  /** Asks until all earlier datagrams are processed. */
  private static void awaitAnswer(DatagramSocket operator, InetSocketAddress drone)
      throws IOException {
    operator.setSoTimeout(1000);
    String reply = "";
    for (int tries = 0; tries < 20 && reply.isEmpty(); tries++) {
      try {
        reply = ask(operator, drone, "battery? are you there");
      } catch (SocketTimeoutException e) {
        reply = "";
      }
    }
    operator.setSoTimeout(20_000);
    assertThat(reply).isEqualTo("unknown command: battery? are you there");
  }

  private static String ask(DatagramSocket operator, InetSocketAddress drone, String text)
      throws IOException {
    send(operator, drone, text);
    return receive(operator);
  }

  private static void send(DatagramSocket from, InetSocketAddress drone, String text)
      throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
    from.send(new DatagramPacket(bytes, bytes.length, drone));
  }

  private static String receive(DatagramSocket socket) throws IOException {
    DatagramPacket packet = new DatagramPacket(new byte[2048], 2048);
    socket.receive(packet);
    return new String(packet.getData(), 0, packet.getLength(), StandardCharsets.ISO_8859_1);
  }

  private Simulation simulation(DroneNetwork network, int statePort) {
    Simulation simulation =
        new Simulation(
            SimConfig.DEFAULT
                .withTimeFactor(new TimeFactor(20))
                .withStreamPorts(new StreamPorts(statePort, 11_111)),
            network.senders(OptionalInt.empty()),
            List.of(counter));
    simulation.control(new Control.Power(1, true));
    return simulation;
  }

  private static Set<String> namesOfNewThreads(Set<Thread> before) {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(thread -> !before.contains(thread) && thread.isAlive())
        .map(Thread::getName)
        .collect(Collectors.toSet());
  }
}
