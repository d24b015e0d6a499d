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
 * A UDP socket. It may have connected sockets beside it, on the same address and port, each for one
 * peer: the system tells those when nothing receives there, and gives them what comes from there.
 */
public final class UdpPort implements DatagramPort {

  /** Is told, on any thread, that something sent did not arrive. */
  @FunctionalInterface
  public interface UnreachableListener {

    /** The system was told by ICMP that nothing receives at a peer's port. */
    void unreachable(InetSocketAddress peer);
  }

  private static final Logger LOG = LoggerFactory.getLogger(UdpPort.class);

  private static final boolean LINUX = System.getProperty("os.name").startsWith("Linux");

  /** Connected sockets beside one. Decided: state, and what a program sends commands from. */
  private static final int MOST_CONNECTED = 8;

  /** Room for a burst of commands while the machine is busy with something else [bytes]. */
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
   * @throws IOException if the address is not of this machine or the port is taken
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

  /** Whether a program has an address, or all addresses with its port. Tries it for a moment. */
  static boolean isTaken(InetSocketAddress address) {
    try (UdpPort probe = open(address)) {
      return probe.address() == null;
    } catch (IOException e) {
      return true;
    }
  }

  /**
   * Opens a socket where a person wants one.
   *
   * @throws PortTakenException with a sentence, if the address is not of this machine or the port
   *     cannot be had
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
   * Opens a socket that sends to one peer alone.
   *
   * @throws IOException if the address is not of this machine or the port is taken
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
   * Opens a connected socket beside this one, through which everything goes to the peer from now
   * on, until it is closed. Only Linux gives the connected one what comes from its peer for sure,
   * so elsewhere there is none. The port stays closed to others: it may be shared just while this
   * runs.
   *
   * @return empty where the system has no such thing
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
   * Closes the connected sockets beside this one, but for those to one host: its program may use
   * some more than once. Of very many, all are closed.
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
   * Lets a selector tell when something has come. From then on nothing blocks: what the system has
   * no room for is lost.
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
   * Takes what came next. For one thread.
   *
   * @param into is filled from its position on; what it has no room for is cut off
   * @return who sent it; null if nothing has come
   * @throws ClosedChannelException if the port was closed
   * @throws IOException if receiving failed this time
   */
  public InetSocketAddress receive(ByteBuffer into) throws IOException {
    try {
      return (InetSocketAddress) channel.receive(into);
    } catch (PortUnreachableException e) { // in place of a datagram
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
