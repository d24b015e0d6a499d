package tellosimulator.video;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.command.Link;
import tellosimulator.command.Peer;
import tellosimulator.network.DatagramPort;
import tellosimulator.network.UdpPort;
import tellosimulator.time.Metronome;

/**
 * Sends a drone's video to its operator's host, from the drone's own address. Its socket is not
 * that of the commands, so that replies never wait behind a picture. For the drone's video thread.
 */
final class VideoConnection implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(VideoConnection.class);

  /** Where the drone's video comes from. Measured: once, in SDK mode. */
  private static final int DRONES_PORT = 62512;

  /** How long it is not tried again where there was no socket [ns]. Decided. */
  private static final long RETRY = 1_000_000_000;

  private final Metronome metronome;
  private Optional<DatagramPort> port = Optional.empty();
  private InetAddress refused;
  private long retryNanos;

  /** Opens nothing yet. */
  VideoConnection(Metronome metronome) {
    this.metronome = metronome;
  }

  /**
   * Sends the datagrams of a picture, spread over some time as the drone does, so that they do not
   * overrun a receiver.
   *
   * @param nanos from the first datagram to the last [ns]
   */
  void send(List<byte[]> packets, Link link, long nanos) {
    if (link.operator().isEmpty()) {
      return;
    }
    Peer operator = link.operator().get();
    Optional<DatagramPort> from = port(operator.via().getAddress());
    if (from.isEmpty()) {
      return;
    }
    InetSocketAddress to = new InetSocketAddress(operator.address().getAddress(), link.videoPort());
    long begun = metronome.nanos();
    for (int i = 0; i < packets.size(); i++) {
      if (i > 0) {
        metronome.pauseUntil(begun + nanos * i / (packets.size() - 1));
      }
      byte[] packet = packets.get(i);
      from.get().send(packet, to);
    }
  }

  private Optional<DatagramPort> port(InetAddress address) {
    if (port.isEmpty() || !port.get().address().getAddress().equals(address)) {
      close();
      if (address.equals(refused) && metronome.nanos() < retryNanos) {
        return port;
      }
      port = open(address, DRONES_PORT).or(() -> open(address, 0));
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
    retryNanos = metronome.nanos() + RETRY;
  }

  private static Optional<DatagramPort> open(InetAddress address, int port) {
    try {
      return Optional.of(UdpPort.open(new InetSocketAddress(address, port)));
    } catch (IOException e) {
      LOG.debug("No socket for video at {}:{}: {}", address, port, e.toString());
      return Optional.empty();
    }
  }

  @Override
  public void close() {
    port.ifPresent(DatagramPort::close);
    port = Optional.empty();
  }
}
