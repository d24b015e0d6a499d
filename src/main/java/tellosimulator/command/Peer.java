package tellosimulator.command;

import java.net.InetSocketAddress;

/**
 * The sender of a command, and the drone's address at which the command arrived. Replies must be
 * sent from that address.
 *
 * @param address the sender's address and port
 * @param via the local address and port that received the command
 */
public record Peer(InetSocketAddress address, InetSocketAddress via) {

  /** Returns the sender's IP address in numeric form, without a port. */
  public String host() {
    return address.getAddress().getHostAddress();
  }

  /** Whether the sender has a loopback address, and is thus a program on this machine. */
  public boolean local() {
    return address.getAddress().isLoopbackAddress();
  }

  @Override
  public String toString() {
    return host() + ":" + address.getPort();
  }
}
