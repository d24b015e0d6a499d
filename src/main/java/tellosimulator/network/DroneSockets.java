package tellosimulator.network;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;

/** The sockets of one drone. Not thread-safe. */
final class DroneSockets {

  private final List<UdpPort> open = new ArrayList<>();
  private final Traffic traffic = new Traffic();

  /**
   * Opens a socket at each of the addresses, or no socket at all. If the system chooses the port of
   * the first socket, the others use the same port.
   *
   * @throws PortTakenException if a socket cannot be opened
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
   * Removes the open sockets that are not at any of these addresses, and returns them for closing.
   */
  List<UdpPort> releaseAllBut(List<InetSocketAddress> addresses) {
    List<UdpPort> released =
        open.stream().filter(port -> !addresses.contains(port.address())).toList();
    open.removeAll(released);
    return released;
  }

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
