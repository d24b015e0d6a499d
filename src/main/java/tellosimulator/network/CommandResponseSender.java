package tellosimulator.network;

import java.net.InetSocketAddress;
import java.util.OptionalInt;
import java.util.function.Consumer;
import tellosimulator.command.Link;
import tellosimulator.command.Peer;
import tellosimulator.command.ReplyPort;
import tellosimulator.command.WireText;
import tellosimulator.network.Ports.Outgoing;

/**
 * The only source of a drone's replies: through the port that received the command, to where it
 * came from or to a fixed port of that host. Called on the simulation thread.
 */
public final class CommandResponseSender implements ReplyPort {

  private final int drone;
  private final Ports ports;
  private final OptionalInt fixedPort;
  private final Consumer<Link> linked;

  /**
   * Of drone 1.
   *
   * @param fixedPort the port to which all replies go; empty for the port each command came from
   */
  public CommandResponseSender(Ports ports, OptionalInt fixedPort) {
    this(1, ports, fixedPort, link -> {});
  }

  /**
   * @param drone its number, from 1
   * @param linked is told of each other link
   */
  CommandResponseSender(int drone, Ports ports, OptionalInt fixedPort, Consumer<Link> linked) {
    this.drone = drone;
    this.ports = ports;
    this.fixedPort = fixedPort;
    this.linked = linked;
  }

  @Override
  public void reply(Peer peer, String text) {
    InetSocketAddress to =
        fixedPort.isPresent()
            ? new InetSocketAddress(peer.address().getAddress(), fixedPort.getAsInt())
            : peer.address();
    Outgoing reply = new Outgoing(drone, WireTap.Kind.REPLY, WireText.encode(text));
    ports.send(peer.via(), reply, to);
  }

  @Override
  public void linked(Link link) {
    linked.accept(link);
  }
}
