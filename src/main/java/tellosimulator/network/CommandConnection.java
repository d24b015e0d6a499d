package tellosimulator.network;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.Optional;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.sim.Simulation;

/**
 * Takes the datagrams that come to one port of a drone, and counts them. Those that are turned away
 * make no garbage, as floods consist of them. For the receiver's thread.
 */
final class CommandConnection {

  private static final Logger LOG = LoggerFactory.getLogger(CommandConnection.class);

  private final int drone;
  private final InetSocketAddress address;
  private final Ports ports;
  private final Gate gate;
  private final Traffic traffic;
  private boolean loopTold;
  private boolean failing;

  /** Decides whether a datagram is taken. */
  @FunctionalInterface
  interface Gate {

    /**
     * Whether the simulation is to have it.
     *
     * @param via the drone's own address that it came to
     * @param bytes begin with the datagram
     * @param length of the datagram [bytes]
     */
    boolean admits(InetAddress sender, InetAddress via, byte[] bytes, int length);
  }

  /**
   * Has taken nothing yet.
   *
   * @param drone its number, from 1
   * @param address the drone's own address and port
   * @param ports of all drones; what comes from one of them is no command
   * @param traffic counts what comes
   */
  CommandConnection(int drone, InetSocketAddress address, Ports ports, Gate gate, Traffic traffic) {
    this.drone = drone;
    this.address = address;
    this.ports = ports;
    this.gate = gate;
    this.traffic = traffic;
  }

  int drone() {
    return drone;
  }

  /** Decides what becomes of a datagram; empty if it is turned away. */
  Optional<DatagramBatch.Entry> take(InetSocketAddress sender, byte[] bytes, int length) {
    traffic.countReceived();
    if (ports.own(sender)) {
      tellLoop();
      return Optional.empty();
    }
    if (!gate.admits(sender.getAddress(), address.getAddress(), bytes, length)) {
      return Optional.empty();
    }
    Peer peer = new Peer(sender, address);
    return Optional.of(new DatagramBatch.Entry(this, peer, WireText.decode(bytes, length)));
  }

  /** Gives a datagram to the simulation, which may have no room for it. */
  void handOver(Simulation simulation, DatagramBatch.Entry entry) {
    simulation.submit(drone, entry.peer(), entry.text());
  }

  private void tellLoop() {
    if (!loopTold) {
      LOG.warn(
          "Drone {} receives its own replies or state lines at {}: give --command-port,"
              + " --state-port and --reply-port different ports",
          drone,
          address);
    }
    loopTold = true;
  }

  /** Its socket could not be read; told once until it works again. */
  void fails(IOException failure) {
    if (!failing) {
      LOG.warn("Receiving on {} failed: {}", address, failure.getMessage());
    }
    failing = true;
  }

  /** Its socket could be read. */
  void works() {
    failing = false;
  }
}
