package tellosimulator.view.pilot;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.StandardProtocolFamily;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The UDP socket of an operator program on this machine, connected with a drone's command port; its
 * own port is chosen by the system. Never blocks; for one thread.
 */
final class OperatorSocket implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(OperatorSocket.class);

  /** Longer than the longest reply [bytes]. */
  private static final int BUFFER = 2048;

  private final DatagramChannel channel;
  private final InetSocketAddress drone;
  private final ByteBuffer buffer = ByteBuffer.allocate(BUFFER);

  private OperatorSocket(DatagramChannel channel, InetSocketAddress drone) {
    this.channel = channel;
    this.drone = drone;
  }

  /**
   * Opens a socket.
   *
   * @throws IOException if the system has none left
   */
  static OperatorSocket open(InetSocketAddress drone) throws IOException {
    DatagramChannel channel = DatagramChannel.open(StandardProtocolFamily.INET);
    try {
      channel.configureBlocking(false);
      channel.connect(drone);
      return new OperatorSocket(channel, drone);
    } catch (IOException | RuntimeException e) {
      channel.close();
      throw e;
    }
  }

  /** The drone that it reaches. */
  InetSocketAddress drone() {
    return drone;
  }

  /**
   * Sends a command.
   *
   * @throws IOException if it cannot go out, or if the last one met a closed port
   */
  void send(String command) throws IOException {
    channel.write(ByteBuffer.wrap(command.getBytes(StandardCharsets.ISO_8859_1)));
  }

  /**
   * The next reply, if one has come.
   *
   * @throws IOException if a command met a closed port
   */
  Optional<String> receive() throws IOException {
    buffer.clear();
    if (channel.receive(buffer) == null) {
      return Optional.empty();
    }
    buffer.flip();
    return Optional.of(StandardCharsets.ISO_8859_1.decode(buffer).toString());
  }

  @Override
  public void close() {
    try {
      channel.close();
    } catch (IOException e) {
      LOG.debug("Closing the socket to {} failed: {}", drone, e.toString());
    }
  }
}
