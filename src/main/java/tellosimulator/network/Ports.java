package tellosimulator.network;

import java.net.InetSocketAddress;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.Map;

/** The open ports of all drones, by their local address. Immutable; for any thread. */
public final class Ports implements AutoCloseable {

  private final Map<InetSocketAddress, DatagramPort> byAddress = new LinkedHashMap<>();

  public Ports(Collection<? extends DatagramPort> ports) {
    ports.forEach(port -> byAddress.put(port.address(), port));
  }

  /** Sends from the port at {@code from}, if it is still there. */
  void send(InetSocketAddress from, byte[] bytes, InetSocketAddress to) {
    DatagramPort port = byAddress.get(from);
    if (port != null) {
      port.send(bytes, to);
    }
  }

  /** Whether what came from {@code sender} was sent by one of these ports. */
  boolean own(InetSocketAddress sender) {
    return byAddress.containsKey(sender);
  }

  @Override
  public void close() {
    byAddress.values().forEach(DatagramPort::close);
  }
}
