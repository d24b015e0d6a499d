package tellosimulator.proxy;

import java.io.IOException;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.StandardProtocolFamily;
import java.nio.channels.DatagramChannel;
import java.util.Optional;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.network.PortTakenException;
import tellosimulator.network.UdpPort;
import tellosimulator.sim.SimConfig.StreamPorts;

/**
 * Where the drone's state and video come in: at the one address of this machine from which it is
 * reached, so that other programs may have these ports at other addresses. That changes when the
 * machine joins another network. For one thread, but for {@link #streamPorts}.
 */
final class DronePorts implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(DronePorts.class);

  private final InetSocketAddress drone;
  private final StreamPorts wanted;
  private Optional<InetAddress> local = Optional.empty();
  private Optional<UdpPort> state = Optional.empty();
  private Optional<UdpPort> video = Optional.empty();
  private volatile StreamPorts streamPorts = new StreamPorts(0, 0);
  private boolean lostTold;

  DronePorts(InetSocketAddress drone, StreamPorts wanted) {
    this.drone = drone;
    this.wanted = wanted;
  }

  Optional<UdpPort> state() {
    return state;
  }

  Optional<UdpPort> video() {
    return video;
  }

  /** Which ports these are; 0 while there are none. */
  StreamPorts streamPorts() {
    return streamPorts;
  }

  /**
   * Opens both sockets, if this machine reaches the drone from another address than before. Where
   * there is no way to it, they stay as they were.
   *
   * @return whether they are new
   * @throws PortTakenException if one cannot be had; then there are none
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
      state = Optional.of(open(host, wanted.statePort(), "state", "--state-port"));
      video = Optional.of(open(host, wanted.videoPort(), "video", "--video-port"));
    } catch (PortTakenException e) {
      close();
      throw e;
    }
    streamPorts = new StreamPorts(state.get().address().getPort(), video.get().address().getPort());
    local = now;
    LOG.debug("The drone is reached from {}", host.getHostAddress());
    return true;
  }

  private static UdpPort open(InetAddress host, int port, String what, String option)
      throws PortTakenException {
    InetSocketAddress address = new InetSocketAddress(host, port);
    try {
      return UdpPort.open(address);
    } catch (IOException e) {
      throw PortTakenException.takenFromProxy(address, what, option, e);
    }
  }

  /**
   * The address of this machine from which datagrams go there; empty if there is no way. Asks the
   * system alone: nothing is sent.
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
    state.ifPresent(UdpPort::close);
    video.ifPresent(UdpPort::close);
    state = Optional.empty();
    video = Optional.empty();
    local = Optional.empty();
    streamPorts = new StreamPorts(0, 0);
  }
}
