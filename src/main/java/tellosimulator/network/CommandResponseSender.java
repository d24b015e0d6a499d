package tellosimulator.network;

import java.net.InetSocketAddress;
import java.util.OptionalInt;
import java.util.function.Consumer;
import tellosimulator.command.Link;
import tellosimulator.command.Peer;
import tellosimulator.command.ReplyPort;
import tellosimulator.command.WireText;

/**
 * The only source of a drone's replies: through the port that received the command, to where it
 * came from or to a fixed port of that host. Called on the simulation thread.
 */
public final class CommandResponseSender implements ReplyPort {

  private final Ports ports;
  private final OptionalInt fixedPort;
  private final Consumer<Link> linked;

  /**
   * @param fixedPort the port to which all replies go; empty for the port each command came from
   */
  public CommandResponseSender(Ports ports, OptionalInt fixedPort) {
    this(ports, fixedPort, link -> {});
  }

  /**
   * @param linked is told of each other link
   */
  CommandResponseSender(Ports ports, OptionalInt fixedPort, Consumer<Link> linked) {
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
    ports.send(peer.via(), WireText.encode(text), to);
  }

  @Override
  public void linked(Link link) {
    linked.accept(link);
  }
}
