package tellosimulator.pilot;

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
 * The UDP socket of an operator program on this machine, connected to a drone's command port. The
 * system chooses the socket's own port. Never blocks. Not thread-safe.
 */
public final class OperatorSocket implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(OperatorSocket.class);

  /** Size of the receive buffer [bytes]. It is larger than the longest reply. */
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
   * @throws IOException if the system cannot provide one
   */
  public static OperatorSocket open(InetSocketAddress drone) throws IOException {
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

  /** Returns the address of the drone's command port. */
  public InetSocketAddress drone() {
    return drone;
  }

  /**
   * Sends a command.
   *
   * @throws IOException if it cannot be sent, or if the previous command reached a closed port
   */
  public void send(String command) throws IOException {
    channel.write(ByteBuffer.wrap(command.getBytes(StandardCharsets.ISO_8859_1)));
  }

  /**
   * Returns the next reply, if one has arrived.
   *
   * @throws IOException if a command reached a closed port
   */
  public Optional<String> receive() throws IOException {
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
