package tellosimulator.network;

import java.net.InetSocketAddress;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/** The open ports of all drones, by their local address. For any thread. */
public final class Ports {

  private record Open(DatagramPort port, Traffic traffic) {}

  private final Map<InetSocketAddress, Open> byAddress = new ConcurrentHashMap<>();

  /** None are open yet. */
  Ports() {}

  public Ports(Collection<? extends DatagramPort> ports) {
    ports.forEach(port -> add(port, new Traffic()));
  }

  /**
   * One more that is open.
   *
   * @param traffic counts what it sends
   */
  void add(DatagramPort port, Traffic traffic) {
    byAddress.put(port.address(), new Open(port, traffic));
  }

  /** Closes these and forgets them. */
  void close(List<? extends DatagramPort> ports) {
    for (DatagramPort port : ports) {
      byAddress.remove(port.address());
      port.close();
    }
  }

  /** Sends from the port at {@code from}, if it is still there. */
  void send(InetSocketAddress from, byte[] bytes, InetSocketAddress to) {
    Open open = byAddress.get(from);
    if (open != null) {
      open.traffic().countSent(); // first, so that who has a reply finds it counted
      open.port().send(bytes, to);
    }
  }

  /** Whether what came from {@code sender} was sent by one of these ports. */
  boolean own(InetSocketAddress sender) {
    return byAddress.containsKey(sender);
  }
}
