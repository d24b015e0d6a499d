package tellosimulator.video;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.command.OperatorEndpoint;
import tellosimulator.command.Packetizer;
import tellosimulator.network.DatagramPort;
import tellosimulator.network.UdpPort;
import tellosimulator.time.Ticker;

/**
 * Sends a drone's video from the drone's address to the operator's host. Its socket is separate
 * from the socket for commands, so that replies never wait behind a picture. Confined to the
 * drone's video thread.
 */
final class VideoConnection implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(VideoConnection.class);

  /** Source port of a real drone's video. Measured once, in SDK mode. */
  private static final int DRONES_PORT = 62512;

  /**
   * Maximum time to wait for a report from another machine that its port is unreachable [ns].
   * Decided.
   */
  private static final long ANSWER = 20_000_000;

  /** Time between attempts to open a socket after a failure [ns]. Decided. */
  private static final long RETRY = 1_000_000_000;

  /** The route of a stream, from an address of the drone to a port of the operator's host. */
  record Route(InetAddress from, InetSocketAddress to, Packetizer packetizer) {

    /** Returns the route to the operator; empty if there is no operator. */
    static Optional<Route> of(OperatorEndpoint link) {
      return link.at(link.videoPort())
          .map(peer -> new Route(peer.via().getAddress(), peer.address(), link.packetizer()));
    }
  }

  /** Opens a connected socket that notifies a listener if the destination is unreachable. */
  @FunctionalInterface
  interface Connector {
    DatagramPort connect(
        InetSocketAddress from, InetSocketAddress to, UdpPort.UnreachableListener listener)
        throws IOException;
  }

  private final Ticker ticker;
  private final Runnable unreachable;
  private final Connector connector;
  private final VideoFaults faults;
  private final UnaryOperator<DatagramPort> tapped;
  private Optional<DatagramPort> port = Optional.empty();
  private Route opened;
  private InetAddress refused;
  private long retryNanos;
  private boolean gone;
  private boolean untried;

  /**
   * Creates a connection without opening a socket.
   *
   * @param unreachable called when another machine reports its port as unreachable
   * @param faults the faults that act on the datagrams
   * @param tapped wraps a port so that the datagrams it sends can be tapped
   */
  VideoConnection(
      Ticker ticker, Runnable unreachable, VideoFaults faults, UnaryOperator<DatagramPort> tapped) {
    this(ticker, unreachable, faults, tapped, UdpPort::connect);
  }

  VideoConnection(
      Ticker ticker,
      Runnable unreachable,
      VideoFaults faults,
      UnaryOperator<DatagramPort> tapped,
      Connector connector) {
    this.tapped = tapped;
    this.faults = faults;
    this.ticker = ticker;
    this.unreachable = unreachable;
    this.connector = connector;
  }

  /**
   * Sends the datagrams of a picture, spread over time as on the drone, so that they do not overrun
   * a receiver. After the first datagram on a new connection to another machine, this method waits
   * for a possible report that the port is unreachable.
   *
   * @param nanos the time from the first datagram to the last [ns]
   */
  void send(List<byte[]> packets, Route route, long nanos) {
    Optional<DatagramPort> from = port(route);
    if (from.isEmpty()) {
      return;
    }
    gone = false;
    long begun = ticker.nanos();
    for (int i = 0; i < packets.size() && !gone; i++) {
      if (i == 1 && untried) {
        untried = false;
        begun += ANSWER;
      }
      if (i > 0) {
        ticker.pauseUntil(begun + nanos * i / (packets.size() - 1));
      }
      faults.deliver(ticker.nanos());
      faults.send(from.get(), route.to(), packets.get(i), ticker.nanos());
    }
  }

  private Optional<DatagramPort> port(Route route) {
    InetAddress address = route.from();
    if (port.isEmpty() || !route.equals(opened)) {
      close();
      if (address.equals(refused) && ticker.nanos() < retryNanos) {
        return port;
      }
      opened = route;
      untried = !route.to().getAddress().isLoopbackAddress();
      port = open(route, DRONES_PORT).or(() -> open(route, 0));
      if (port.isEmpty()) {
        refuse(address);
      }
    }
    return port;
  }

  private void refuse(InetAddress address) {
    if (!address.equals(refused)) {
      LOG.warn("There is no socket for video at {}, so no video is sent", address);
    }
    refused = address;
    retryNanos = ticker.nanos() + RETRY;
  }

  /**
   * Opens a socket. A socket to another machine is connected, so that an unreachable port is
   * detected.
   */
  private Optional<DatagramPort> open(Route route, int port) {
    InetSocketAddress from = new InetSocketAddress(route.from(), port);
    try {
      return Optional.of(
          tapped.apply(
              route.to().getAddress().isLoopbackAddress()
                  ? UdpPort.open(from)
                  : connector.connect(from, route.to(), peer -> lost())));
    } catch (IOException e) {
      LOG.debug("No socket for video at {}: {}", from, e.toString());
      return Optional.empty();
    }
  }

  private void lost() {
    gone = true;
    untried = true;
    unreachable.run();
  }

  @Override
  public void close() {
    faults.forget();
    port.ifPresent(DatagramPort::close);
    port = Optional.empty();
  }
}
