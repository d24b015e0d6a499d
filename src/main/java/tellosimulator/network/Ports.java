package tellosimulator.network;

import java.net.InetSocketAddress;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/** The open ports of all drones, by local address. Thread-safe. */
public final class Ports {

  private record Open(DatagramPort port, Traffic traffic) {}

  private final Map<InetSocketAddress, Open> byAddress = new ConcurrentHashMap<>();
  private volatile WireTap tap = WireTap.NONE;

  /** A datagram sent by a drone. */
  @SuppressWarnings("ArrayRecordComponent") // never compared, and the bytes are never modified
  record Outgoing(int drone, WireTap.Kind kind, byte[] bytes) {}

  private final boolean real;

  private Ports(boolean real) {
    this.real = real;
  }

  /** Creates an empty set of ports. */
  Ports() {
    this(true);
  }

  /** Returns ports that send nothing, but notify the tap of every datagram that would be sent. */
  static Ports withoutSockets() {
    return new Ports(false);
  }

  public Ports(Collection<? extends DatagramPort> ports) {
    this(true);
    ports.forEach(port -> add(port, new Traffic()));
  }

  /**
   * Adds an open port.
   *
   * @param traffic counts the datagrams that the port sends
   */
  void add(DatagramPort port, Traffic traffic) {
    byAddress.put(port.address(), new Open(port, traffic));
  }

  /** Closes and removes ports. */
  void close(List<? extends DatagramPort> ports) {
    for (DatagramPort port : ports) {
      byAddress.remove(port.address());
      port.close();
    }
  }

  /** Sets the tap that is notified of every datagram that is sent. */
  void setTap(WireTap newTap) {
    tap = newTap;
  }

  WireTap tap() {
    return tap;
  }

  /** Sends a datagram from the port at {@code from}, if that port is still open. */
  void send(InetSocketAddress from, Outgoing datagram, InetSocketAddress to) {
    Open open = byAddress.get(from);
    if (!real) {
      tap.sent(datagram.drone(), datagram.kind(), from, to, datagram.bytes());
    } else if (open != null) {
      open.traffic().countSent(); // first, so that a reply is counted before it is received
      tap.sent(datagram.drone(), datagram.kind(), from, to, datagram.bytes());
      open.port().send(datagram.bytes(), to);
    }
  }

  /** Returns whether {@code sender} is the address of one of these ports. */
  boolean own(InetSocketAddress sender) {
    return byAddress.containsKey(sender);
  }
}
