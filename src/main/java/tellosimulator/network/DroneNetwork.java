package tellosimulator.network;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.command.DronePort;
import tellosimulator.command.OperatorEndpoint;
import tellosimulator.command.Peer;
import tellosimulator.sim.Simulation;
import tellosimulator.time.TokenBucket;

/**
 * The sockets of all drones, connected to a simulation. Each drone's sockets are opened and closed
 * separately. Thread-safe.
 */
public final class DroneNetwork implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(DroneNetwork.class);

  /**
   * Maximum rate at which connected sockets are opened [1/s]. Decided: enough for a program that is
   * restarted.
   */
  private static final double CONNECTS_PER_SECOND = 4;

  private static final double MOST_CONNECTS = 64;

  private final List<DroneSockets> drones;
  private final Ports ports = new Ports();

  private final Set<Integer> on = new TreeSet<>();

  /** The latest operator endpoint of each drone. */
  private final Map<Integer, OperatorEndpoint> links = new TreeMap<>();

  private final List<AdmissionControl> admissions = new ArrayList<>();

  /**
   * Limits how often connected sockets are opened, because each command may come from another port,
   * and sockets are expensive.
   */
  private final TokenBucket connecting = new TokenBucket(CONNECTS_PER_SECOND, MOST_CONNECTS);

  private final Supplier<LocalNetworks> look;
  private volatile AddressPlan plan;
  private volatile LocalNetworks networks;

  /**
   * The listen addresses of each drone, either open or planned. Readers need no lock, so they never
   * wait while sockets are opened.
   */
  private volatile List<List<InetSocketAddress>> published = List.of();

  private volatile Optional<Simulation> simulation = Optional.empty();
  private Optional<Receiver> receiver = Optional.empty();

  /** Addresses that could not be opened when they appeared; each is logged once. */
  private final List<InetSocketAddress> refused = new ArrayList<>();

  private DroneNetwork(AddressPlan plan, Supplier<LocalNetworks> look) {
    this.plan = plan;
    this.look = look;
    networks = look.get();
    drones = plan.drones().stream().map(drone -> new DroneSockets()).toList();
    publish();
  }

  /** Creates a network without opening sockets. */
  public static DroneNetwork of(AddressPlan plan) {
    return of(plan, LocalNetworks::look);
  }

  /**
   * Creates a network without opening sockets.
   *
   * @param look looks up this machine's addresses
   */
  static DroneNetwork of(AddressPlan plan, Supplier<LocalNetworks> look) {
    return new DroneNetwork(plan, look);
  }

  /**
   * Returns a function from a drone's number to the drone's sender.
   *
   * @param fixedPort the port to which all replies go; empty for the port from which each command
   *     came
   */
  public IntFunction<DronePort> senders(OptionalInt fixedPort) {
    return drone -> new DatagramSender(drone, ports, fixedPort, link -> connect(drone, link));
  }

  /** Sets the tap that is notified of every datagram that the drones send. */
  void setTap(WireTap tap) {
    ports.setTap(tap);
  }

  WireTap tap() {
    return ports.tap();
  }

  /**
   * Starts to pass received datagrams to a simulation.
   *
   * @throws IllegalStateException if the system is out of resources
   */
  public synchronized void listen(Simulation to) {
    simulation = Optional.of(to);
    receiver = Optional.of(Receiver.start(to));
    for (int drone = 1; drone <= drones.size(); drone++) {
      admissions.add(new AdmissionControl(drone, to));
      for (UdpPort port : sockets(drone).ports()) {
        receive(drone, port);
      }
    }
  }

  /**
   * Opens a drone's sockets at all current addresses of the machine, if they are closed.
   *
   * @param drone the drone's number, from 1
   * @throws PortTakenException if a socket cannot be opened; in this case, no socket of the drone
   *     is open
   */
  public synchronized void open(int drone) throws PortTakenException {
    if (!sockets(drone).isOpen()) {
      networks = look.get();
      open(drone, planned(drone));
      on.add(drone);
    }
    publish();
  }

  private void open(int drone, List<InetSocketAddress> addresses) throws PortTakenException {
    for (InetSocketAddress address : addresses) {
      if (!plan.allows(drone, address.getAddress())) {
        throw PortTakenException.offLimits(address);
      }
    }
    DroneSockets sockets = sockets(drone);
    List<UdpPort> before = sockets.ports();
    sockets.open(addresses);
    plan = plan.withPort(drone, sockets.addresses().get(0).getPort());
    for (UdpPort port : sockets.ports()) {
      if (!before.contains(port)) {
        ports.add(port, sockets.traffic());
        receive(drone, port);
      }
    }
  }

  /** Closes a drone's sockets if they are open. The ports are free when this method returns. */
  public synchronized void close(int drone) {
    release(drone, List.of());
    on.remove(drone);
    publish();
  }

  /**
   * Looks up the machine's addresses again. Each drone that is on begins to listen at new
   * addresses, and stops listening at addresses that have disappeared.
   */
  public void refresh() {
    LocalNetworks found = look.get(); // slow, and therefore outside the lock
    synchronized (this) {
      networks = found;
      on.forEach(this::adopt);
      Map.copyOf(links).forEach(this::connect);
      publish();
    }
  }

  /** Closes a drone's sockets except those at the given addresses. */
  private void release(int drone, List<InetSocketAddress> kept) {
    List<UdpPort> released = sockets(drone).releaseAllBut(kept);
    ports.close(released);
    if (!released.isEmpty()) {
      receiver.ifPresent(Receiver::settle);
    }
  }

  private void adopt(int drone) {
    List<InetSocketAddress> wanted =
        planned(drone).stream().filter(each -> plan.allows(drone, each.getAddress())).toList();
    release(drone, wanted);
    for (InetSocketAddress address : wanted) {
      if (sockets(drone).addresses().contains(address)) {
        continue;
      }
      try {
        open(drone, List.of(address));
        LOG.info("Drone {} also listens at {}", drone, address);
        refused.remove(address);
      } catch (PortTakenException e) {
        if (!refused.contains(address)) {
          refused.add(address);
          LOG.warn("Drone {} does not listen at {}: {}", drone, address, e.getMessage());
        }
      }
    }
  }

  /**
   * Returns whether at least one drone is on, but no drone has received anything, and no drone uses
   * the port that operator programs bind.
   */
  synchronized boolean silent() {
    return !on.isEmpty()
        && drones.stream().allMatch(drone -> drone.traffic().received() == 0)
        && published.stream()
            .flatMap(List::stream)
            .noneMatch(address -> address.getPort() == AddressPlan.REAL_COMMAND_PORT);
  }

  /** Returns the reach of the drones that listen on the machine's own addresses. */
  public Reach reach() {
    return plan.reach();
  }

  /** Sets the reach. This takes effect immediately, even for drones that are on. */
  public void setReach(Reach reach) {
    synchronized (this) {
      if (plan.reach() != reach) {
        LOG.info(
            reach == Reach.NETWORK
                ? "Other machines of this network can reach the drones now"
                : "Only this machine can reach the drones now");
      }
      plan = plan.withReach(reach);
    }
    refresh();
  }

  /** Reports to the simulation how many datagrams have been rejected since the last call. */
  public synchronized void reportDropped() {
    admissions.forEach(AdmissionControl::report);
  }

  /**
   * Sets the port on which a drone listens after the next {@link #open(int)}.
   *
   * @param port the port; 0 lets the system choose
   */
  public synchronized void setPort(int drone, int port) {
    sockets(drone);
    plan = plan.withPort(drone, port);
    publish();
  }

  /**
   * Returns the addresses where a drone listens, or would listen if its sockets were open. Never
   * waits.
   */
  public List<InetSocketAddress> addresses(int drone) {
    sockets(drone);
    return published.get(drone - 1);
  }

  /** Returns the listen addresses of each drone, in the order of drone numbers. Never waits. */
  public List<List<InetSocketAddress>> addresses() {
    return published;
  }

  private void publish() {
    List<List<InetSocketAddress>> all = new ArrayList<>();
    for (int drone = 1; drone <= drones.size(); drone++) {
      DroneSockets sockets = sockets(drone);
      all.add(sockets.isOpen() ? sockets.addresses() : planned(drone));
    }
    published = List.copyOf(all);
  }

  private List<InetSocketAddress> planned(int drone) {
    return plan.addresses(drone, networks);
  }

  /**
   * Waits until all datagrams that have arrived at the sockets have been passed to the simulation.
   */
  public void settle() {
    Optional<Receiver> current;
    synchronized (this) {
      current = receiver;
    }
    current.ifPresent(Receiver::settle);
  }

  /** Returns the datagram counts of a drone. */
  public Traffic traffic(int drone) {
    return sockets(drone).traffic();
  }

  @Override
  public synchronized void close() {
    for (int drone = 1; drone <= drones.size(); drone++) {
      close(drone);
    }
    receiver.ifPresent(Receiver::close);
    receiver = Optional.empty();
  }

  private void receive(int drone, UdpPort port) {
    receiver.ifPresent(
        to ->
            to.add(
                port,
                new CommandConnection(drone, port.address(), ports, gate(drone), traffic(drone))));
  }

  private CommandConnection.Gate gate(int drone) {
    AdmissionControl admission = admissions.get(drone - 1);
    return (sender, via, bytes, length) -> admission.admits(sender, via, bytes, length, networks);
  }

  /**
   * If the operator is on another machine, opens connected sockets to it, one for replies and one
   * for state lines, so that the simulation is notified when no program receives the replies or
   * state lines. Closes connected sockets to other hosts. Called on the simulation thread, and by
   * {@link #refresh}.
   */
  private synchronized void connect(int drone, OperatorEndpoint link) {
    links.put(drone, link);
    Optional<Peer> remote = link.operator().filter(operator -> !operator.local());
    for (UdpPort port : sockets(drone).ports()) {
      Optional<Peer> here = remote.filter(operator -> operator.via().equals(port.address()));
      port.keepConnected(here.map(operator -> operator.address().getAddress()));
      here.ifPresent(operator -> connect(drone, port, operator, link.statePort()));
    }
    receiver.ifPresent(Receiver::settleSoon);
  }

  /**
   * Connects sockets to an operator. The socket for state lines is always opened, because state
   * lines are sent continually. The socket for replies, which are few, is opened only if the rate
   * limit allows it.
   */
  private void connect(int drone, UdpPort port, Peer operator, int statePort) {
    connect(drone, port, new InetSocketAddress(operator.address().getAddress(), statePort));
    if (!port.isConnectedTo(operator.address()) && connecting.tryTake()) {
      connect(drone, port, operator.address());
    }
  }

  private void connect(int drone, UdpPort port, InetSocketAddress to) {
    if (!port.isConnectedTo(to)) {
      port.beside(to, gone -> simulation.ifPresent(each -> each.unreachable(drone, gone)))
          .ifPresent(beside -> receive(drone, beside));
    }
  }

  private DroneSockets sockets(int drone) {
    if (drone < 1 || drone > drones.size()) {
      throw new IllegalArgumentException(
          "there is no drone " + drone + ", the drones are 1 to " + drones.size());
    }
    return drones.get(drone - 1);
  }
}
