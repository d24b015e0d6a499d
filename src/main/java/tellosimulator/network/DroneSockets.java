package tellosimulator.network;

import java.io.IOException;
import java.net.BindException;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;

/** The sockets of one drone: all open, or none. */
final class DroneSockets {

  private List<InetSocketAddress> addresses;
  private List<UdpPort> open = List.of();
  private final Traffic traffic = new Traffic();

  DroneSockets(List<InetSocketAddress> addresses) {
    this.addresses = List.copyOf(addresses);
  }

  /**
   * Opens all sockets, or none. A port that the system chose is the drone's port from now on.
   *
   * @throws PortTakenException if one cannot be had
   */
  void open() throws PortTakenException {
    List<UdpPort> opened = new ArrayList<>();
    try {
      for (InetSocketAddress address : addresses) {
        opened.add(open(address));
      }
    } catch (PortTakenException e) {
      opened.forEach(UdpPort::close);
      throw e;
    }
    open = List.copyOf(opened);
    addresses = open.stream().map(UdpPort::address).toList();
  }

  /** Forgets the open sockets, and returns them to be closed. */
  List<UdpPort> release() {
    List<UdpPort> released = open;
    open = List.of();
    return released;
  }

  /** Where it listens, or will listen. */
  List<InetSocketAddress> addresses() {
    return addresses;
  }

  /** Another port on the same addresses, from the next {@link #open()} on. */
  void setPort(int port) {
    addresses =
        addresses.stream()
            .map(address -> new InetSocketAddress(address.getAddress(), port))
            .toList();
  }

  List<UdpPort> ports() {
    return open;
  }

  boolean isOpen() {
    return !open.isEmpty();
  }

  Traffic traffic() {
    return traffic;
  }

  private static UdpPort open(InetSocketAddress address) throws PortTakenException {
    try {
      return UdpPort.open(address);
    } catch (BindException e) {
      throw exists(address)
          ? PortTakenException.taken(address, e)
          : PortTakenException.noSuchAddress(address, e);
    } catch (IOException e) {
      throw PortTakenException.forbidden(address, e);
    }
  }

  private static boolean exists(InetSocketAddress address) {
    try (UdpPort probe = UdpPort.open(new InetSocketAddress(address.getAddress(), 0))) {
      return probe.address() != null;
    } catch (IOException e) {
      return false;
    }
  }
}
