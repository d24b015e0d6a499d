package tellosimulator.command;

import java.net.InetSocketAddress;

/**
 * Who sent a command, and which of the drone's own addresses it was sent to, from which the replies
 * must leave.
 *
 * @param address the sender
 * @param via the local address and port that received it
 */
public record Peer(InetSocketAddress address, InetSocketAddress via) {

  /** The sender's host as a client writes it, without a port. */
  public String host() {
    return address.getAddress().getHostAddress();
  }

  /** Whether it is a program on this machine that uses loopback. */
  public boolean local() {
    return address.getAddress().isLoopbackAddress();
  }

  @Override
  public String toString() {
    return host() + ":" + address.getPort();
  }
}
