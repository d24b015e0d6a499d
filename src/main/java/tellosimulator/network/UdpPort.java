package tellosimulator.network;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.command.WireText;

/** A UDP socket. */
public final class UdpPort implements DatagramPort {

  private static final Logger LOG = LoggerFactory.getLogger(UdpPort.class);

  /** Longer than the longest command, so that a longer one is seen to be longer [bytes]. */
  private static final int BUFFER = 2048;

  /** Room for a burst of commands while the machine is busy with something else [bytes]. */
  private static final int SOCKET_BUFFER = 1 << 18;

  private final DatagramChannel channel;
  private final InetSocketAddress address;
  private final ByteBuffer buffer = ByteBuffer.allocateDirect(BUFFER);

  private UdpPort(DatagramChannel channel, InetSocketAddress address) {
    this.channel = channel;
    this.address = address;
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
      return new UdpPort(channel, (InetSocketAddress) channel.getLocalAddress());
    } catch (IOException | RuntimeException e) {
      channel.close();
      throw e;
    }
  }

  @Override
  public InetSocketAddress address() {
    return address;
  }

  @Override
  public Received receive() throws IOException {
    buffer.clear();
    InetSocketAddress sender = (InetSocketAddress) channel.receive(buffer);
    buffer.flip();
    byte[] bytes = new byte[buffer.remaining()];
    buffer.get(bytes);
    return new Received(sender, WireText.decode(bytes, bytes.length));
  }

  @Override
  public void send(byte[] bytes, InetSocketAddress to) {
    try {
      channel.send(ByteBuffer.wrap(bytes), to);
    } catch (IOException e) {
      LOG.debug("A datagram from {} to {} was lost: {}", address, to, e.toString());
    }
  }

  @Override
  public void close() {
    try {
      channel.close();
    } catch (IOException e) {
      LOG.debug("Closing {} failed: {}", address, e.toString());
    }
  }
}
