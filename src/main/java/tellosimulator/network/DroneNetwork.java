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
import tellosimulator.command.Link;
import tellosimulator.command.Peer;
import tellosimulator.command.ReplyPort;
import tellosimulator.sim.Simulation;
import tellosimulator.sim.StatePort;
import tellosimulator.time.TokenBucket;

/**
 * The sockets of all drones, opened and closed drone by drone, and connected with a simulation. For
 * any thread.
 */
public final class DroneNetwork implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(DroneNetwork.class);

  /** Connected sockets that are opened at the most. Decided: a program that is restarted. */
  private static final double CONNECTS_PER_SECOND = 4;

  private static final double MOST_CONNECTS = 64;

  private final List<DroneSockets> drones;
  private final Ports ports = new Ports();

  /** The numbers of the drones that are on. */
  private final Set<Integer> on = new TreeSet<>();

  /** How each drone was linked last. */
  private final Map<Integer, Link> links = new TreeMap<>();

  private final List<AdmissionControl> admissions = new ArrayList<>();

  /** Each command may come from another port, and a socket and a thread for it are not free. */
  private final TokenBucket connecting = new TokenBucket(CONNECTS_PER_SECOND, MOST_CONNECTS);

  private final Supplier<LocalNetworks> look;
  private volatile AddressPlan plan;
  private volatile LocalNetworks networks;

  /** Where each drone listens or would listen, for those who do not wait for sockets. */
  private volatile List<List<InetSocketAddress>> published = List.of();

  private volatile Optional<Simulation> simulation = Optional.empty();
  private Optional<Receiver> receiver = Optional.empty();

  /** Addresses that could not be opened when they appeared; told once. */
  private final List<InetSocketAddress> refused = new ArrayList<>();

  private DroneNetwork(AddressPlan plan, Supplier<LocalNetworks> look) {
    this.plan = plan;
    this.look = look;
    networks = look.get();
    drones = plan.drones().stream().map(drone -> new DroneSockets()).toList();
    publish();
  }

  /** Nothing is open yet. */
  public static DroneNetwork of(AddressPlan plan) {
    return of(plan, LocalNetworks::look);
  }

  /**
   * Nothing is open yet.
   *
   * @param look finds this machine's addresses
   */
  static DroneNetwork of(AddressPlan plan, Supplier<LocalNetworks> look) {
    return new DroneNetwork(plan, look);
  }

  /**
   * Opens the sockets of all drones, or none.
   *
   * @throws PortTakenException if one cannot be had
   */
  public static DroneNetwork open(AddressPlan plan) throws PortTakenException {
    DroneNetwork network = of(plan);
    try {
      for (int drone = 1; drone <= network.drones.size(); drone++) {
        network.open(drone);
      }
      return network;
    } catch (PortTakenException e) {
      network.close();
      throw e;
    }
  }

  /** The way out for the replies of the drone of a number; see {@link CommandResponseSender}. */
  public IntFunction<ReplyPort> replies(OptionalInt fixedPort) {
    return drone ->
        new CommandResponseSender(drone, ports, fixedPort, link -> connect(drone, link));
  }

  /** Who sees what comes to the drones and what leaves them, from now on. */
  void setTap(WireTap tap) {
    ports.setTap(tap);
  }

  WireTap tap() {
    return ports.tap();
  }

  /** The way out for state lines. */
  public StatePort states() {
    return new StateConnection(ports);
  }

  /**
   * Hands what is received to a simulation, from now on.
   *
   * @throws IllegalStateException if the system has no more of what that takes
   */
  public synchronized void listen(Simulation to) {
    simulation = Optional.of(to);
    to.listen(new TakenDatagrams(ports));
    receiver = Optional.of(Receiver.start(to));
    for (int drone = 1; drone <= drones.size(); drone++) {
      admissions.add(new AdmissionControl(drone, to));
      for (UdpPort port : sockets(drone).ports()) {
        receive(drone, port);
      }
    }
  }

  /**
   * Opens a drone's sockets at all addresses that the machine has now, if they are closed.
   *
   * @param drone its number, from 1
   * @throws PortTakenException if one cannot be had; then none is open
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

  /** Closes a drone's sockets, if they are open; its ports are free when this returns. */
  public synchronized void close(int drone) {
    release(drone, List.of());
    on.remove(drone);
    publish();
  }

  /**
   * Looks at the machine's addresses anew: drones that are on listen at those that have appeared,
   * and no more at those that have gone.
   */
  public void refresh() {
    LocalNetworks found = look.get(); // which takes a while
    synchronized (this) {
      networks = found;
      on.forEach(this::adopt);
      Map.copyOf(links).forEach(this::connect);
      publish();
    }
  }

  /** Closes a drone's sockets but for those at some addresses. */
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

  /** Whether drones are on, none of them at the port of operators, and nothing has come to any. */
  synchronized boolean silent() {
    return !on.isEmpty()
        && drones.stream().allMatch(drone -> drone.traffic().received() == 0)
        && published.stream()
            .flatMap(List::stream)
            .noneMatch(address -> address.getPort() == AddressPlan.REAL_COMMAND_PORT);
  }

  /** From where the drones that listen on the machine's own addresses can be reached. */
  public Reach reach() {
    return plan.reach();
  }

  /** Changes it at once, also for drones that are on. */
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

  /** Tells the simulation how many datagrams were turned away since the last time. */
  public synchronized void reportDropped() {
    admissions.forEach(AdmissionControl::report);
  }

  /**
   * Lets a drone listen on another port from the next {@link #open(int)} on.
   *
   * @param port 0 for one that the system chooses
   */
  public synchronized void setPort(int drone, int port) {
    sockets(drone);
    plan = plan.withPort(drone, port);
    publish();
  }

  /** Where a drone listens while its sockets are open, or would listen; never waits. */
  public List<InetSocketAddress> addresses(int drone) {
    sockets(drone);
    return published.get(drone - 1);
  }

  /** Where each drone listens, in the order of their numbers; never waits. */
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

  /** Waits until all that has come to the sockets is handed to the simulation. */
  public void settle() {
    Optional<Receiver> current;
    synchronized (this) {
      current = receiver;
    }
    current.ifPresent(Receiver::settle);
  }

  /** What a drone received and sent. */
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
   * Gives an operator on another machine sockets of its own, for replies and for state lines, so
   * that the simulation is told when nothing receives there. On the simulation thread.
   */
  private synchronized void connect(int drone, Link link) {
    links.put(drone, link);
    Optional<Peer> remote = link.operator().filter(operator -> !operator.local());
    for (UdpPort port : sockets(drone).ports()) {
      Optional<Peer> here = remote.filter(operator -> operator.via().equals(port.address()));
      port.keepConnected(here.map(operator -> operator.address().getAddress()));
      here.ifPresent(operator -> connect(drone, port, operator, link.statePort()));
    }
    receiver.ifPresent(Receiver::settleSoon);
  }

  /** State comes first and always: replies are few, but state never ends. */
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
