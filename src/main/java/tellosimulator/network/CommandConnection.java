package tellosimulator.network;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.Arrays;
import java.util.Optional;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.command.Peer;
import tellosimulator.sim.Simulation;

/**
 * Counts the datagrams that arrive at one port of a drone, and accepts or rejects them. Rejected
 * datagrams allocate nothing, so a flood causes no garbage collection. Confined to the receiver's
 * thread.
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

  /** Decides whether a datagram is accepted. */
  @FunctionalInterface
  interface Gate {

    /**
     * Returns whether a datagram is passed on to the simulation.
     *
     * @param via the drone's own address at which the datagram arrived
     * @param bytes a buffer that starts with the datagram
     * @param length the datagram's length [bytes]
     */
    boolean admits(InetAddress sender, InetAddress via, byte[] bytes, int length);
  }

  /**
   * Creates a connection.
   *
   * @param drone the drone's number, from 1
   * @param address the drone's own address and port
   * @param ports the ports of all drones; a datagram from one of them is not a command
   * @param traffic counts received datagrams
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

  /** Processes a received datagram; returns an empty result if the datagram is rejected. */
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
    return Optional.of(new DatagramBatch.Entry(this, peer, Arrays.copyOf(bytes, length)));
  }

  /** Submits a datagram to the simulation. The simulation may drop it if its queue is full. */
  void handOver(Simulation simulation, DatagramBatch.Entry entry) {
    simulation.submit(drone, entry.peer(), entry.bytes());
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

  /**
   * Logs a failed read of the socket. Further failures are not logged until a read has succeeded.
   */
  void fails(IOException failure) {
    if (!failing) {
      LOG.warn("Receiving on {} failed: {}", address, failure.getMessage());
    }
    failing = true;
  }

  /** Records that a read of the socket succeeded. */
  void works() {
    failing = false;
  }
}
