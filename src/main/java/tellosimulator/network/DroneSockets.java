package tellosimulator.network;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;

/** The sockets of one drone. Not safe for several threads at once. */
final class DroneSockets {

  private final List<UdpPort> open = new ArrayList<>();
  private final Traffic traffic = new Traffic();

  /**
   * Opens sockets at all these addresses, or none. Where the system chooses a port for the first
   * one, the others have the same.
   *
   * @throws PortTakenException if one cannot be had
   */
  void open(List<InetSocketAddress> addresses) throws PortTakenException {
    int before = open.size();
    try {
      for (InetSocketAddress address : addresses) {
        open.add(UdpPort.bind(withPort(address)));
      }
    } catch (PortTakenException e) {
      List<UdpPort> opened = open.subList(before, open.size());
      opened.forEach(UdpPort::close);
      opened.clear();
      throw e;
    }
  }

  private InetSocketAddress withPort(InetSocketAddress address) {
    boolean chosen = address.getPort() == 0 && !open.isEmpty();
    return chosen
        ? new InetSocketAddress(address.getAddress(), open.get(0).address().getPort())
        : address;
  }

  /**
   * Forgets the open sockets that are at none of these addresses, and returns them to be closed.
   */
  List<UdpPort> releaseAllBut(List<InetSocketAddress> addresses) {
    List<UdpPort> released =
        open.stream().filter(port -> !addresses.contains(port.address())).toList();
    open.removeAll(released);
    return released;
  }

  /** Where it listens now. */
  List<InetSocketAddress> addresses() {
    return open.stream().map(UdpPort::address).toList();
  }

  List<UdpPort> ports() {
    return List.copyOf(open);
  }

  boolean isOpen() {
    return !open.isEmpty();
  }

  Traffic traffic() {
    return traffic;
  }
}
