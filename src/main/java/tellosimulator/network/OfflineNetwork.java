package tellosimulator.network;

import java.util.OptionalInt;
import java.util.function.IntFunction;
import tellosimulator.command.DronePort;

/**
 * Replaces the sockets in a simulation that runs without a network. Notifies a tap of every
 * datagram that would be sent. Confined to the simulation thread.
 */
public final class OfflineNetwork {

  private final Ports ports = Ports.withoutSockets();

  /**
   * Creates an offline network.
   *
   * @param tap notified of every datagram
   */
  public OfflineNetwork(WireTap tap) {
    ports.setTap(tap);
  }

  /**
   * Returns a function from a drone's number to the drone's sender.
   *
   * @param fixedPort the port to which all replies go; empty for the port from which each command
   *     came
   */
  public IntFunction<DronePort> senders(OptionalInt fixedPort) {
    return drone -> new DatagramSender(drone, ports, fixedPort, link -> {});
  }
}
