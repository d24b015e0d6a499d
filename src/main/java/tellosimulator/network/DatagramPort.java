package tellosimulator.network;

import java.net.InetSocketAddress;

/** A local address and port that datagrams leave from. */
public interface DatagramPort extends AutoCloseable {

  /** Where others reach it. */
  InetSocketAddress address();

  /** Sends, or loses, a datagram. For any thread; never throws. */
  void send(byte[] bytes, InetSocketAddress to);

  @Override
  void close();
}
