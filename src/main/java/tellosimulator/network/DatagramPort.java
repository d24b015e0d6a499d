package tellosimulator.network;

import java.io.IOException;
import java.net.InetSocketAddress;

/** A local address and port that datagrams come to and leave from. */
public interface DatagramPort extends AutoCloseable {

  /**
   * A datagram that arrived.
   *
   * @param text its bytes as ISO-8859-1; of very long ones at least 2,000 bytes
   */
  record Received(InetSocketAddress sender, String text) {}

  /** Where others reach it. */
  InetSocketAddress address();

  /**
   * Blocks until something arrives. For one thread.
   *
   * @throws java.nio.channels.ClosedChannelException if the port was or is closed
   * @throws IOException if receiving failed this time
   */
  Received receive() throws IOException;

  /** Sends, or loses, a datagram. For any thread; never throws. */
  void send(byte[] bytes, InetSocketAddress to);

  /** Ends {@link #receive} too. */
  @Override
  void close();
}
