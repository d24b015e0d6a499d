package tellosimulator.network;

import java.io.IOException;
import java.net.BindException;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import tellosimulator.command.ReplyPort;
import tellosimulator.sim.Simulation;
import tellosimulator.sim.StatePort;

/** The sockets of all drones: opened first, then connected with a simulation. */
public final class DroneNetwork implements AutoCloseable {

  private final List<List<UdpPort>> drones;
  private final Ports ports;

  private DroneNetwork(List<List<UdpPort>> drones) {
    this.drones = drones;
    this.ports = new Ports(drones.stream().flatMap(List::stream).toList());
  }

  /**
   * Opens all ports, or none.
   *
   * @throws PortTakenException if one cannot be had
   */
  public static DroneNetwork open(AddressPlan plan) throws PortTakenException {
    List<List<UdpPort>> drones = new ArrayList<>();
    try {
      for (List<InetSocketAddress> addresses : plan.drones()) {
        List<UdpPort> ports = new ArrayList<>();
        drones.add(ports);
        for (InetSocketAddress address : addresses) {
          ports.add(open(address));
        }
      }
      return new DroneNetwork(drones);
    } catch (PortTakenException e) {
      drones.stream().flatMap(List::stream).forEach(UdpPort::close);
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

  /** Starts to receive. */
  public void listen(Simulation simulation) {
    for (int i = 0; i < drones.size(); i++) {
      for (UdpPort port : drones.get(i)) {
        CommandConnection.listen(i + 1, port, ports, simulation);
      }
    }
  }

  /** Where each drone listens, in the order of their numbers. */
  public List<List<InetSocketAddress>> addresses() {
    return drones.stream().map(ports -> ports.stream().map(UdpPort::address).toList()).toList();
  }

  @Override
  public void close() {
    ports.close();
  }

  private static UdpPort open(InetSocketAddress address) throws PortTakenException {
    try {
      return UdpPort.open(address);
    } catch (BindException e) {
      throw exists(address)
          ? PortTakenException.taken(address, e)
          : PortTakenException.noSuchAddress(address, e);
    } catch (IOException e) {
      throw PortTakenException.forbidden(address, e);
    }
  }

  private static boolean exists(InetSocketAddress address) {
    try (UdpPort probe = UdpPort.open(new InetSocketAddress(address.getAddress(), 0))) {
      return probe.address() != null;
    } catch (IOException e) {
      return false;
    }
  }
}
