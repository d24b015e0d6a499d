package tellosimulator.proxy;

import java.io.IOException;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.StandardProtocolFamily;
import java.nio.channels.DatagramChannel;
import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.network.PortTakenException;
import tellosimulator.network.UdpPort;
import tellosimulator.network.WireTap.Kind;
import tellosimulator.sim.SimConfig.StreamPorts;

/**
 * The sockets that receive the drone's state and video. They are bound only to the local address
 * from which this machine reaches the drone, so that other programs may use the same ports at other
 * addresses. That address changes when the machine joins another network. Not thread-safe, except
 * for {@link #streamPorts}.
 */
final class DronePorts implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(DronePorts.class);

  private final InetSocketAddress drone;
  private final StreamPorts wanted;
  private Optional<InetAddress> local = Optional.empty();
  private final Map<Kind, UdpPort> ports = new EnumMap<>(Kind.class);
  private volatile StreamPorts streamPorts = new StreamPorts(0, 0);
  private boolean lostTold;

  DronePorts(InetSocketAddress drone, StreamPorts wanted) {
    this.drone = drone;
    this.wanted = wanted;
  }

  /** The open sockets, by the kind of datagrams that they receive. */
  Map<Kind, UdpPort> ports() {
    return ports;
  }

  /** The ports of the state and video sockets; 0 while no socket is open. Thread-safe. */
  StreamPorts streamPorts() {
    return streamPorts;
  }

  /**
   * Opens both sockets if this machine now reaches the drone from another address. If there is no
   * route to the drone, the sockets are left unchanged.
   *
   * @return whether new sockets were opened
   * @throws PortTakenException if a socket cannot be opened; no socket is open afterwards
   */
  boolean follow() throws PortTakenException {
    Optional<InetAddress> now = source(drone);
    if (now.isEmpty() && !lostTold) {
      LOG.warn(
          "There is no way to the drone at {} yet: join its network",
          drone.getAddress().getHostAddress());
    }
    lostTold = now.isEmpty();
    if (now.isEmpty() || now.equals(local)) {
      return false;
    }
    close();
    InetAddress host = now.get();
    try {
      ports.put(Kind.STATE, open(host, wanted.statePort(), Kind.STATE));
      ports.put(Kind.VIDEO, open(host, wanted.videoPort(), Kind.VIDEO));
    } catch (PortTakenException e) {
      close();
      throw e;
    }
    streamPorts = new StreamPorts(number(Kind.STATE), number(Kind.VIDEO));
    local = now;
    LOG.debug("The drone is reached from {}", host.getHostAddress());
    return true;
  }

  private int number(Kind kind) {
    return ports.get(kind).address().getPort();
  }

  private static UdpPort open(InetAddress host, int port, Kind kind) throws PortTakenException {
    InetSocketAddress address = new InetSocketAddress(host, port);
    try {
      return UdpPort.open(address);
    } catch (IOException e) {
      String option = "--" + kind.word() + "-port";
      throw PortTakenException.takenFromProxy(address, kind.word(), option, e);
    }
  }

  /**
   * Returns the address of this machine from which datagrams to the target are sent; empty if there
   * is no route. The method only queries the system and sends nothing.
   */
  private static Optional<InetAddress> source(InetSocketAddress to) {
    try (DatagramChannel probe = DatagramChannel.open(StandardProtocolFamily.INET)) {
      InetSocketAddress from = (InetSocketAddress) probe.connect(to).getLocalAddress();
      return Optional.of(from.getAddress())
          .filter(address -> address instanceof Inet4Address && !address.isAnyLocalAddress());
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  @Override
  public void close() {
    ports.values().forEach(UdpPort::close);
    ports.clear();
    local = Optional.empty();
    streamPorts = new StreamPorts(0, 0);
  }
}
