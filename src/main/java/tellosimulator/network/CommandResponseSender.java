package tellosimulator.network;

import java.net.InetSocketAddress;
import java.util.OptionalInt;
import tellosimulator.command.Peer;
import tellosimulator.command.ReplyPort;
import tellosimulator.command.WireText;

/**
 * The only source of replies: through the port that received the command, to where it came from or
 * to a fixed port of that host. Called on the simulation thread.
 */
public final class CommandResponseSender implements ReplyPort {

  private final Ports ports;
  private final OptionalInt fixedPort;

  /**
   * @param fixedPort the port to which all replies go; empty for the port each command came from
   */
  public CommandResponseSender(Ports ports, OptionalInt fixedPort) {
    this.ports = ports;
    this.fixedPort = fixedPort;
  }

  @Override
  public void reply(Peer peer, String text) {
    InetSocketAddress to =
        fixedPort.isPresent()
            ? new InetSocketAddress(peer.address().getAddress(), fixedPort.getAsInt())
            : peer.address();
    ports.send(peer.via(), WireText.encode(text), to);
  }
}
