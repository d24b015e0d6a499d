package tellosimulator.network;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static tellosimulator.testing.SteppedDrone.address;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import tellosimulator.math.Vec3;
import tellosimulator.sim.Control;
import tellosimulator.sim.Formation;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.Simulation;
import tellosimulator.sim.SimulationLoop;
import tellosimulator.testing.CapturedLog;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Room;

/** Uses real sockets on loopback, on ports that the system chooses. */
@Timeout(value = 60, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class DroneNetworkTest {

  private static final InetAddress FIRST = address("127.0.0.1", 0).getAddress();

  @Test
  void repliesAndStateLeaveFromTheCommandPortOfTheCommandedAddress() throws IOException {
    try (DatagramSocket client = client();
        DatagramSocket states = client();
        DroneNetwork network = OpenNetwork.of(AddressPlan.of(loopbacks(), 0));
        SimulationLoop loop = run(network, states.getLocalPort(), OptionalInt.empty())) {
      assertThat(loop).isNotNull();
      for (List<InetSocketAddress> drone : network.addresses()) {
        InetSocketAddress commanded = drone.get(0);
        send(client, "command", commanded);

        DatagramPacket reply = receive(client);
        assertThat(text(reply)).isEqualTo("ok");
        assertThat(reply.getSocketAddress()).isEqualTo(commanded);

        DatagramPacket state = receiveFrom(states, commanded);
        assertThat(text(state)).startsWith("mid:-2;").endsWith(";\r\n");
      }
    }
  }

  @Test
  void aFixedReplyPortTakesAllReplies() throws IOException {
    try (DatagramSocket client = client();
        DatagramSocket fixed = client();
        DroneNetwork network = OpenNetwork.of(AddressPlan.of(List.of(FIRST), 0));
        SimulationLoop loop = run(network, 1, OptionalInt.of(fixed.getLocalPort()))) {
      assertThat(loop).isNotNull();
      send(client, "command", network.addresses().get(0).get(0));

      assertThat(text(receive(fixed))).isEqualTo("ok");
    }
  }

  @Test
  void aTakenPortIsNamedInOneSentence() throws IOException {
    try (DatagramSocket taken = client()) {
      InetSocketAddress address = address("127.0.0.1", taken.getLocalPort());

      assertThatThrownBy(() -> OpenNetwork.of(plan(address)))
          .isInstanceOf(PortTakenException.class)
          .hasMessage(
              "Port "
                  + taken.getLocalPort()
                  + " of 127.0.0.1 is taken, probably by a Tello simulator that is still running:"
                  + " end that program, or choose another port with --command-port.");
    }
  }

  @Test
  void port8889IsTakenByAnOperatorProgram() {
    assertThat(PortTakenException.taken(address("127.0.0.1", 8889), new IOException("in use")))
        .hasMessage(
            "Port 8889 of 127.0.0.1 is taken, probably by a drone program, which needs that"
                + " port for itself: end that program, or choose another port with"
                + " --command-port.");
  }

  @Test
  void anAddressOfAnotherMachineIsNamed() {
    assertThatThrownBy(() -> OpenNetwork.of(plan(address("203.0.113.77", 0))))
        .isInstanceOf(PortTakenException.class)
        .hasMessage(
            "This machine has no address 203.0.113.77: choose one of this machine's own addresses"
                + " with --bind.");
  }

  @Test
  void anAddressOfTheNetworkIsOpenedOnlyWhereTheNetworkIsAllowed() {
    AddressPlan scenarios =
        AddressPlan.ofMachine(
            List.of(java.util.Optional.of(address("203.0.113.77", 0).getAddress())), List.of(0));

    assertThatThrownBy(() -> OpenNetwork.of(scenarios))
        .isInstanceOf(PortTakenException.class)
        .hasMessage(
            "203.0.113.77 can be reached from the network, but the drones listen on this machine"
                + " only: give --lan to allow it, or in the window switch \"Reachable from the"
                + " network\" on.");
    assertThatThrownBy(() -> OpenNetwork.of(scenarios.withReach(Reach.NETWORK)))
        .isInstanceOf(PortTakenException.class)
        .hasMessageStartingWith("This machine has no address 203.0.113.77");
  }

  @Test
  void aDroneThatIsOnListensElsewhereAsSoonAsTheReachChanges() throws Exception {
    try (CapturedLog log = CapturedLog.of(DroneNetwork.class);
        DroneNetwork network = OpenNetwork.of(AddressPlan.ofMachine(1, 0))) {
      InetSocketAddress local = network.addresses(1).get(0);
      assertThat(network.addresses(1)).containsExactly(local);
      assertThat(local.getAddress()).isEqualTo(FIRST);

      network.setReach(Reach.NETWORK);
      assertThat(log.next()).isEqualTo("Other machines of this network can reach the drones now");
      assertThat(network.addresses(1))
          .startsWith(local)
          .hasSameSizeAs(LocalNetworks.look().addresses())
          .allMatch(each -> each.getPort() == local.getPort());

      network.setReach(Reach.THIS_MACHINE);
      assertThat(network.addresses(1)).containsExactly(local);
    }
  }

  @Test
  void anAddressOfTheNetworkIsClosedAgainWhereTheNetworkIsNoLongerAllowed() throws IOException {
    List<InetAddress> own = LocalNetworks.look().addresses();
    org.junit.jupiter.api.Assumptions.assumeTrue(own.size() > 1, "this machine is in no network");
    AddressPlan scenarios =
        AddressPlan.ofMachine(List.of(java.util.Optional.of(own.get(1))), List.of(0));
    try (DroneNetwork network = OpenNetwork.of(scenarios.withReach(Reach.NETWORK))) {
      InetSocketAddress open = network.addresses(1).get(0);

      network.setReach(Reach.THIS_MACHINE);

      try (DatagramSocket free = new DatagramSocket(open)) {
        assertThat(free.isBound()).isTrue();
      }
      network.setReach(Reach.NETWORK);
      assertThat(network.addresses(1)).containsExactly(open);
      assertThatThrownBy(() -> new DatagramSocket(open).close()).isInstanceOf(IOException.class);
    }
  }

  @Test
  @EnabledOnOs(value = OS.LINUX, disabledReason = "elsewhere 127.0.0.1 is the only such address")
  void addressesThatAppearAreServedAndThoseThatGoAreLeft() throws Exception {
    AtomicReference<LocalNetworks> networks = new AtomicReference<>(new LocalNetworks(List.of()));
    AddressPlan plan = AddressPlan.ofMachine(1, 0).withReach(Reach.NETWORK);
    try (CapturedLog log = CapturedLog.of(DroneNetwork.class);
        DroneNetwork network = DroneNetwork.of(plan, networks::get);
        SimulationLoop loop = run(network, 1, OptionalInt.empty());
        DatagramSocket client = client()) {
      assertThat(loop).isNotNull();
      network.open(1);
      InetSocketAddress first = network.addresses(1).get(0);
      assertThat(network.addresses(1)).containsExactly(first);

      InetSocketAddress second = address("127.0.0.2", first.getPort());
      networks.set(
          new LocalNetworks(List.of(new LocalNetworks.Member(second.getAddress(), Byte.SIZE))));
      network.refresh();
      assertThat(network.addresses(1)).containsExactly(first, second);
      assertThat(log.next()).isEqualTo("Drone 1 also listens at " + second);
      send(client, "command", second);
      assertThat(text(receive(client))).isEqualTo("ok");

      networks.set(new LocalNetworks(List.of()));
      network.refresh();
      assertThat(network.addresses(1)).containsExactly(first);
      try (DatagramSocket free = new DatagramSocket(second)) {
        assertThat(free.isBound()).isTrue();
      }
    }
  }

  @Test
  @EnabledOnOs(value = OS.LINUX, disabledReason = "elsewhere 127.0.0.1 is the only such address")
  void anAddressThatCannotBeServedIsToldOnce() throws Exception {
    AtomicReference<LocalNetworks> networks = new AtomicReference<>(new LocalNetworks(List.of()));
    AddressPlan plan = AddressPlan.ofMachine(1, 0).withReach(Reach.NETWORK);
    try (CapturedLog log = CapturedLog.of(DroneNetwork.class);
        DroneNetwork network = DroneNetwork.of(plan, networks::get)) {
      network.open(1);
      InetSocketAddress first = network.addresses(1).get(0);
      InetSocketAddress second = address("127.0.0.2", first.getPort());
      networks.set(
          new LocalNetworks(List.of(new LocalNetworks.Member(second.getAddress(), Byte.SIZE))));
      try (DatagramSocket taken = new DatagramSocket(second)) {
        assertThat(taken.isBound()).isTrue();
        network.refresh();
        network.refresh();
        assertThat(network.addresses(1)).containsExactly(first);
      }
      network.refresh();

      assertThat(log.next())
          .startsWith("Drone 1 does not listen at " + second + ": Port " + second.getPort());
      assertThat(log.next()).isEqualTo("Drone 1 also listens at " + second);
    }
  }

  @Test
  void aClosedNetworkFreesItsPorts() throws IOException {
    InetSocketAddress address;
    try (DroneNetwork network = OpenNetwork.of(AddressPlan.of(List.of(FIRST), 0))) {
      address = network.addresses().get(0).get(0);
    }

    try (DatagramSocket again = new DatagramSocket(address)) {
      assertThat(again.getLocalPort()).isEqualTo(address.getPort());
    }
  }

  @Test
  void aPortThatIsClosedWhileItWaitsEndsItsThread() throws Exception {
    DroneNetwork network = OpenNetwork.of(AddressPlan.of(List.of(FIRST), 0));
    try (SimulationLoop loop = run(network, 1, OptionalInt.empty())) {
      assertThat(loop).isNotNull();
      List<Thread> receivers = threads("receiver");
      assertThat(receivers).isNotEmpty();

      network.close();

      for (Thread receiver : receivers) {
        receiver.join(TimeUnit.SECONDS.toMillis(30));
        assertThat(receiver.isAlive()).isFalse();
      }
    }
  }

  /** Otherwise each state line would be answered, and so would each answer, endlessly. */
  @Test
  void whatADroneSendsToItselfIsNoCommand() throws IOException {
    List<String> received = new CopyOnWriteArrayList<>();
    SimListener listener =
        new SimListener() {
          @Override
          public void event(SimEvent event) {
            if (event instanceof SimEvent.CommandReceived command) {
              received.add(command.text());
            }
          }
        };
    try (DatagramSocket client = client();
        DroneNetwork network = OpenNetwork.of(AddressPlan.of(List.of(FIRST), 0))) {
      InetSocketAddress drone = network.addresses().get(0).get(0);
      SimulationLoop loop = run(network, drone.getPort(), OptionalInt.empty(), listener);
      send(client, "command", drone);
      assertThat(text(receive(client))).isEqualTo("ok");
      send(client, "takeoff", drone); // three simulated seconds, and thirty state lines
      assertThat(text(receive(client))).isEqualTo("ok");
      loop.close();
    }

    assertThat(received).contains("command", "takeoff").noneMatch(text -> text.startsWith("mid:"));
  }

  private static SimulationLoop run(
      DroneNetwork network, int statePort, OptionalInt replyPort, SimListener... listeners) {
    int drones = network.addresses().size();
    SimConfig config =
        SimConfig.DEFAULT
            .withRoom(Room.DEFAULT, Formation.row(drones, Vec3.ZERO, Room.DEFAULT))
            .withTimeFactor(new TimeFactor(20))
            .withStreamPorts(new StreamPorts(statePort, 11_111));
    Simulation simulation = new Simulation(config, network.senders(replyPort), List.of(listeners));
    for (int drone = 1; drone <= drones; drone++) {
      simulation.control(new Control.Power(drone, true));
    }
    SimulationLoop loop = new SimulationLoop(simulation);
    network.listen(simulation);
    return loop;
  }

  /** Returns the first two loopback addresses; the second one is missing on some systems. */
  private static List<InetAddress> loopbacks() {
    InetAddress second = address("127.0.0.2", 0).getAddress();
    try (DatagramSocket probe = new DatagramSocket(new InetSocketAddress(second, 0))) {
      assertThat(probe.isBound()).isTrue();
      return List.of(FIRST, second);
    } catch (IOException e) {
      return List.of(FIRST);
    }
  }

  private static AddressPlan plan(InetSocketAddress... drones) {
    return new AddressPlan(
        java.util.Arrays.stream(drones)
            .map(each -> new AddressPlan.Endpoint(List.of(each.getAddress()), each.getPort(), true))
            .toList());
  }

  private static DatagramSocket client() throws IOException {
    DatagramSocket socket = new DatagramSocket(address("127.0.0.1", 0));
    socket.setSoTimeout(20_000);
    return socket;
  }

  private static void send(DatagramSocket from, String text, InetSocketAddress to)
      throws IOException {
    byte[] bytes = text.getBytes(java.nio.charset.StandardCharsets.ISO_8859_1);
    from.send(new DatagramPacket(bytes, bytes.length, to));
  }

  private static DatagramPacket receive(DatagramSocket socket) throws IOException {
    DatagramPacket packet = new DatagramPacket(new byte[2048], 2048);
    socket.receive(packet);
    return packet;
  }

  private static DatagramPacket receiveFrom(DatagramSocket socket, InetSocketAddress sender)
      throws IOException {
    DatagramPacket packet = receive(socket);
    while (!packet.getSocketAddress().equals(sender)) {
      packet = receive(socket);
    }
    return packet;
  }

  private static String text(DatagramPacket packet) {
    return new String(
        packet.getData(), 0, packet.getLength(), java.nio.charset.StandardCharsets.ISO_8859_1);
  }

  private static List<Thread> threads(String name) {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(thread -> thread.getName().equals(name))
        .toList();
  }
}
