package tellosimulator.video;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.command.Link;
import tellosimulator.network.DatagramPort;
import tellosimulator.network.UdpPort;
import tellosimulator.time.Ticker;

/**
 * Sends a drone's video to its operator's host, from the drone's own address. Its socket is not
 * that of the commands, so that replies never wait behind a picture. For the drone's video thread.
 */
final class VideoConnection implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(VideoConnection.class);

  /** Where the drone's video comes from. Measured: once, in SDK mode. */
  private static final int DRONES_PORT = 62512;

  /** How long another machine may take to say that nothing receives there [ns]. Decided. */
  private static final long ANSWER = 20_000_000;

  /** How long it is not tried again where there was no socket [ns]. Decided. */
  private static final long RETRY = 1_000_000_000;

  /** The way of a stream: from an address of the drone to a port of its operator's host. */
  record Route(InetAddress from, InetSocketAddress to) {

    /** That of the operator; empty where there is none. */
    static Optional<Route> of(Link link) {
      return link.operator()
          .map(
              operator ->
                  new Route(
                      operator.via().getAddress(),
                      new InetSocketAddress(operator.address().getAddress(), link.videoPort())));
    }
  }

  /** Opens a connected socket, which can say that nothing receives where it sends. */
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
   * Opens nothing yet.
   *
   * @param unreachable is called when another machine says that nothing receives there
   * @param faults what goes wrong on the way
   * @param tapped lets somebody see what is sent through a port
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
   * Sends the datagrams of a picture, spread over some time as the drone does, so that they do not
   * overrun a receiver. After the first datagram ever to another machine it waits whether that says
   * that nothing receives there.
   *
   * @param nanos from the first datagram to the last [ns]
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

  /** A connected socket to another machine, which can say that nothing receives there. */
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
