package tellosimulator.network;

import java.net.InetSocketAddress;
import java.util.OptionalInt;
import java.util.function.Consumer;
import tellosimulator.command.DronePort;
import tellosimulator.command.LinkDatagram;
import tellosimulator.command.OperatorEndpoint;
import tellosimulator.command.Peer;
import tellosimulator.fault.LinkDirection;
import tellosimulator.network.Ports.Outgoing;

/**
 * Sends the replies and state lines of a drone. A datagram for a program is sent from the port that
 * received the commands of that program. Replies go to the port from which the program sent its
 * command, or to a fixed port of its host. Called on the simulation thread.
 */
public final class DatagramSender implements DronePort {

  private final int drone;
  private final Ports ports;
  private final OptionalInt fixedPort;
  private final Consumer<OperatorEndpoint> linked;

  /**
   * Creates the sender of drone 1.
   *
   * @param fixedPort the port to which all replies go; empty for the port from which each command
   *     came
   */
  public DatagramSender(Ports ports, OptionalInt fixedPort) {
    this(1, ports, fixedPort, link -> {});
  }

  /**
   * Creates the sender of a drone.
   *
   * @param drone the drone's number, from 1
   * @param linked notified when the operator endpoint changes
   */
  DatagramSender(int drone, Ports ports, OptionalInt fixedPort, Consumer<OperatorEndpoint> linked) {
    this.drone = drone;
    this.ports = ports;
    this.fixedPort = fixedPort;
    this.linked = linked;
  }

  @Override
  public void send(LinkDatagram datagram) {
    Peer peer = datagram.peer();
    boolean state = datagram.direction() == LinkDirection.STATE;
    InetSocketAddress to =
        state || fixedPort.isEmpty()
            ? peer.address()
            : new InetSocketAddress(peer.address().getAddress(), fixedPort.getAsInt());
    WireTap.Kind kind = state ? WireTap.Kind.STATE : WireTap.Kind.REPLY;
    ports.send(peer.via(), new Outgoing(drone, kind, datagram.bytes()), to);
  }

  @Override
  public void linked(OperatorEndpoint link) {
    linked.accept(link);
  }
}
