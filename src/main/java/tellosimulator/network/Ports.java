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
  private volatile WireTap tap = WireTap.NONE;

  /** What leaves a drone. */
  @SuppressWarnings("ArrayRecordComponent") // never compared, and nobody changes the bytes
  record Outgoing(int drone, WireTap.Kind kind, byte[] bytes) {}

  /** Whether there are sockets at all. */
  private final boolean real;

  private Ports(boolean real) {
    this.real = real;
  }

  /** None are open yet. */
  Ports() {
    this(true);
  }

  /** From which nothing leaves; the tap sees all that would. */
  static Ports withoutSockets() {
    return new Ports(false);
  }

  public Ports(Collection<? extends DatagramPort> ports) {
    this(true);
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

  /** Who sees what passes, from now on. */
  void setTap(WireTap newTap) {
    tap = newTap;
  }

  /** Who sees what passes. */
  WireTap tap() {
    return tap;
  }

  /** Sends from the port at {@code from}, if it is still there. */
  void send(InetSocketAddress from, Outgoing datagram, InetSocketAddress to) {
    Open open = byAddress.get(from);
    if (!real) {
      tap.sent(datagram.drone(), datagram.kind(), from, to, datagram.bytes());
    } else if (open != null) {
      open.traffic().countSent(); // first, so that who has a reply finds it counted
      tap.sent(datagram.drone(), datagram.kind(), from, to, datagram.bytes());
      open.port().send(datagram.bytes(), to);
    }
  }

  /** Whether what came from {@code sender} was sent by one of these ports. */
  boolean own(InetSocketAddress sender) {
    return byAddress.containsKey(sender);
  }
}
