package tellosimulator.network;

import java.io.IOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.PortUnreachableException;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A UDP socket. On the same address and port, there may also be connected sockets, each for one
 * peer. The system notifies a connected socket when no program receives at the peer, and delivers
 * the peer's datagrams to that socket.
 */
public final class UdpPort implements DatagramPort {

  /** A listener that is notified, on any thread, that a sent datagram did not arrive. */
  @FunctionalInterface
  public interface UnreachableListener {

    /** Called when ICMP reports that no program receives at a peer's port. */
    void unreachable(InetSocketAddress peer);
  }

  private static final Logger LOG = LoggerFactory.getLogger(UdpPort.class);

  private static final boolean LINUX = System.getProperty("os.name").startsWith("Linux");

  /**
   * Maximum number of connected sockets on the address and port of one socket. Decided: one for
   * state lines, and the others for the ports from which a program sends commands.
   */
  private static final int MOST_CONNECTED = 8;

  /**
   * Size of the receive buffer [bytes]. It holds a burst of commands that arrives while the machine
   * is busy.
   */
  private static final int SOCKET_BUFFER = 1 << 18;

  private final DatagramChannel channel;
  private final InetSocketAddress address;

  private final Optional<InetSocketAddress> peer;
  private final UnreachableListener listener;
  private final Map<InetSocketAddress, UdpPort> connected = new ConcurrentHashMap<>();

  private UdpPort(DatagramChannel channel) throws IOException {
    this.channel = channel;
    this.address = (InetSocketAddress) channel.getLocalAddress();
    this.peer = Optional.empty();
    this.listener = unreachable -> {};
  }

  private UdpPort(DatagramChannel channel, InetSocketAddress peer, UnreachableListener listener)
      throws IOException {
    this.channel = channel;
    this.address = (InetSocketAddress) channel.getLocalAddress();
    this.peer = Optional.of(peer);
    this.listener = listener;
  }

  /**
   * Opens a socket.
   *
   * @throws IOException if the address does not belong to this machine or the port is taken
   */
  public static UdpPort open(InetSocketAddress address) throws IOException {
    DatagramChannel channel = DatagramChannel.open(java.net.StandardProtocolFamily.INET);
    try {
      channel.setOption(StandardSocketOptions.SO_RCVBUF, SOCKET_BUFFER);
      channel.bind(address);
      return new UdpPort(channel);
    } catch (IOException | RuntimeException e) {
      channel.close();
      throw e;
    }
  }

  /**
   * Returns whether a program has bound an address, or all addresses on the same port. To find out,
   * this method binds the address briefly.
   */
  static boolean isTaken(InetSocketAddress address) {
    try (UdpPort probe = open(address)) {
      return probe.address() == null;
    } catch (IOException e) {
      return true;
    }
  }

  /**
   * Opens a socket at an address that a user requested.
   *
   * @throws PortTakenException if the address does not belong to this machine or the port cannot be
   *     opened; the message is one sentence
   */
  public static UdpPort bind(InetSocketAddress address) throws PortTakenException {
    try {
      return open(address);
    } catch (BindException e) {
      throw exists(address)
          ? PortTakenException.taken(address, e)
          : PortTakenException.noSuchAddress(address, e);
    } catch (IOException e) {
      throw PortTakenException.forbidden(address, e);
    }
  }

  private static boolean exists(InetSocketAddress address) {
    try (UdpPort probe = open(new InetSocketAddress(address.getAddress(), 0))) {
      return probe.address() != null;
    } catch (IOException e) {
      return false;
    }
  }

  /**
   * Opens a socket that sends to a single peer.
   *
   * @throws IOException if the address does not belong to this machine or the port is taken
   */
  public static UdpPort connect(
      InetSocketAddress address, InetSocketAddress peer, UnreachableListener listener)
      throws IOException {
    return connect(address, peer, listener, false);
  }

  private static UdpPort connect(
      InetSocketAddress address,
      InetSocketAddress peer,
      UnreachableListener listener,
      boolean beside)
      throws IOException {
    DatagramChannel channel = DatagramChannel.open(java.net.StandardProtocolFamily.INET);
    try {
      channel.setOption(StandardSocketOptions.SO_RCVBUF, SOCKET_BUFFER);
      channel.setOption(StandardSocketOptions.SO_REUSEADDR, beside);
      channel.bind(address);
      channel.connect(peer);
      return new UdpPort(channel, peer, listener);
    } catch (IOException | RuntimeException e) {
      channel.close();
      throw e;
    }
  }

  /**
   * Opens a connected socket on the same address and port as this one. All datagrams to the peer
   * are sent through the new socket until it is closed. Only Linux reliably delivers the peer's
   * datagrams to the connected socket, so this method opens none on other systems. Other programs
   * still cannot bind the port, because sharing is allowed only during this call.
   *
   * @return the socket; empty if the system does not support connected sockets on a shared port
   */
  Optional<UdpPort> beside(InetSocketAddress to, UnreachableListener whom) {
    if (!LINUX) {
      return Optional.empty();
    }
    try {
      channel.setOption(StandardSocketOptions.SO_REUSEADDR, true);
      UdpPort port = connect(address, to, whom, true);
      connected.put(to, port);
      return Optional.of(port);
    } catch (IOException e) {
      LOG.debug("No connected socket from {} to {}: {}", address, to, e.toString());
      return Optional.empty();
    } finally {
      shareNoMore();
    }
  }

  private void shareNoMore() {
    try {
      channel.setOption(StandardSocketOptions.SO_REUSEADDR, false);
    } catch (IOException e) {
      LOG.debug("{} was closed meanwhile: {}", address, e.toString());
    }
  }

  /**
   * Closes the connected sockets except those to the given host, because a program on that host may
   * use them again. Closes all of them if there are more than {@link #MOST_CONNECTED}.
   */
  void keepConnected(Optional<InetAddress> host) {
    boolean many = connected.size() > MOST_CONNECTED;
    for (InetSocketAddress other : List.copyOf(connected.keySet())) {
      if (many || host.filter(other.getAddress()::equals).isEmpty()) {
        connected.remove(other).close();
      }
    }
  }

  boolean isConnectedTo(InetSocketAddress to) {
    return connected.containsKey(to);
  }

  @Override
  public InetSocketAddress address() {
    return address;
  }

  /**
   * Registers this port with a selector. From then on, sending does not block: a datagram for which
   * the system has no buffer space is lost.
   */
  public void register(Selector selector, Object attachment) {
    try {
      channel.configureBlocking(false);
      channel.register(selector, SelectionKey.OP_READ, attachment);
    } catch (IOException e) {
      LOG.debug("{} was closed meanwhile: {}", address, e.toString());
    }
  }

  /**
   * Receives the next datagram. Must be called on one thread only.
   *
   * @param into the buffer, which is filled from its position; the part of the datagram that does
   *     not fit is cut off
   * @return the sender; null if no datagram is pending
   * @throws ClosedChannelException if the port has been closed
   * @throws IOException if this attempt to receive failed
   */
  public InetSocketAddress receive(ByteBuffer into) throws IOException {
    try {
      return (InetSocketAddress) channel.receive(into);
    } catch (PortUnreachableException e) { // thrown instead of receiving a datagram
      peer.ifPresent(listener::unreachable);
      return null;
    }
  }

  @Override
  public void send(byte[] bytes, InetSocketAddress to) {
    UdpPort beside = connected.get(to);
    if (beside != null) {
      beside.send(bytes, to);
      return;
    }
    try {
      if (peer.isPresent()) {
        channel.write(ByteBuffer.wrap(bytes));
      } else {
        channel.send(ByteBuffer.wrap(bytes), to);
      }
    } catch (PortUnreachableException e) {
      peer.ifPresent(listener::unreachable);
    } catch (IOException e) {
      LOG.debug("A datagram from {} to {} was lost: {}", address, to, e.toString());
    }
  }

  @Override
  public void close() {
    keepConnected(Optional.empty());
    try {
      channel.close();
    } catch (IOException e) {
      LOG.debug("Closing {} failed: {}", address, e.toString());
    }
  }
}
