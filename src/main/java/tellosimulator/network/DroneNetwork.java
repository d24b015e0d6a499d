package tellosimulator.network;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import tellosimulator.command.ReplyPort;
import tellosimulator.concurrent.Worker;
import tellosimulator.sim.Simulation;
import tellosimulator.sim.StatePort;

/**
 * The sockets of all drones, opened and closed drone by drone, and connected with a simulation. For
 * any thread.
 */
public final class DroneNetwork implements AutoCloseable {

  private final List<DroneSockets> drones;
  private final Ports ports = new Ports();
  private final Map<Integer, List<Worker>> receivers = new HashMap<>();
  private Optional<Simulation> simulation = Optional.empty();

  private DroneNetwork(AddressPlan plan) {
    drones = plan.drones().stream().map(DroneSockets::new).toList();
  }

  /** Nothing is open yet. */
  public static DroneNetwork of(AddressPlan plan) {
    return new DroneNetwork(plan);
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

  /** The way out for replies; see {@link CommandResponseSender}. */
  public ReplyPort replies(OptionalInt fixedPort) {
    return new CommandResponseSender(ports, fixedPort);
  }

  /** The way out for state lines. */
  public StatePort states() {
    return new StateConnection(ports);
  }

  /** Hands what is received to {@code receiver}, from now on. */
  public synchronized void listen(Simulation receiver) {
    simulation = Optional.of(receiver);
    for (int drone = 1; drone <= drones.size(); drone++) {
      receive(drone);
    }
  }

  /**
   * Opens a drone's sockets, if they are closed.
   *
   * @param drone its number, from 1
   * @throws PortTakenException if one cannot be had; then none is open
   */
  public synchronized void open(int drone) throws PortTakenException {
    DroneSockets sockets = sockets(drone);
    if (!sockets.isOpen()) {
      sockets.open();
      sockets.ports().forEach(port -> ports.add(port, sockets.traffic()));
      receive(drone);
    }
  }

  /** Closes a drone's sockets, if they are open; its ports are free when this returns. */
  public synchronized void close(int drone) {
    ports.close(sockets(drone).release());
    receivers.getOrDefault(drone, List.of()).forEach(Worker::close);
    receivers.remove(drone);
  }

  /**
   * Lets a drone listen on another port from the next {@link #open(int)} on.
   *
   * @param port 0 for one that the system chooses
   */
  public synchronized void setPort(int drone, int port) {
    sockets(drone).setPort(port);
  }

  /** Where a drone listens while its sockets are open. */
  public synchronized List<InetSocketAddress> addresses(int drone) {
    return sockets(drone).addresses();
  }

  /** Where each drone listens, in the order of their numbers. */
  public synchronized List<List<InetSocketAddress>> addresses() {
    return drones.stream().map(DroneSockets::addresses).toList();
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
  }

  private void receive(int drone) {
    simulation.ifPresent(
        receiver -> {
          List<Worker> workers = new ArrayList<>();
          for (UdpPort port : sockets(drone).ports()) {
            CommandConnection connection = new CommandConnection(drone, port, ports, receiver);
            workers.add(connection.listen(traffic(drone)));
          }
          receivers.put(drone, workers);
        });
  }

  private DroneSockets sockets(int drone) {
    if (drone < 1 || drone > drones.size()) {
      throw new IllegalArgumentException(
          "there is no drone " + drone + ", the drones are 1 to " + drones.size());
    }
    return drones.get(drone - 1);
  }
}
