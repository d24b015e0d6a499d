package tellosimulator.network;

import java.net.InetSocketAddress;

/** A local address and port from which datagrams are sent. */
public interface DatagramPort extends AutoCloseable {

  /** Returns the local address of this port. */
  InetSocketAddress address();

  /** Sends a datagram. It may be lost. Thread-safe; never throws. */
  void send(byte[] bytes, InetSocketAddress to);

  @Override
  void close();
}
