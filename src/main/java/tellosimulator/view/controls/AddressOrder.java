package tellosimulator.view.controls;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Puts a drone's addresses into the order in which people need them. */
final class AddressOrder {

  private AddressOrder() {}

  /**
   * The address that other machines of the local network probably reach, then loopback for programs
   * on this machine, then all others.
   */
  static List<InetSocketAddress> mostUsefulFirst(List<InetSocketAddress> addresses) {
    List<InetSocketAddress> ordered = new ArrayList<>(addresses);
    ordered.sort(Comparator.comparingInt(address -> rank(address.getAddress())));
    int loopback = 0;
    while (loopback < ordered.size() && !ordered.get(loopback).getAddress().isLoopbackAddress()) {
      loopback++;
    }
    if (loopback > 1 && loopback < ordered.size()) {
      ordered.add(1, ordered.remove(loopback));
    }
    return List.copyOf(ordered);
  }

  /**
   * Low for addresses that local networks have. Assumed: homes and schools use 192.168 and 10;
   * 172.16 to 172.31 is mostly the inner network of containers.
   */
  private static int rank(InetAddress address) {
    byte[] bytes = address.getAddress();
    if (address.isLoopbackAddress()) {
      return 4;
    }
    if (address.isLinkLocalAddress()) {
      return 3;
    }
    if (address.isSiteLocalAddress()) {
      return (bytes[0] & 0xff) == 172 ? 2 : 0;
    }
    return 1;
  }
}
