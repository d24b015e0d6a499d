package tellosimulator.network;

import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.net.UnknownHostException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/**
 * Which drone listens where.
 *
 * @param drones for each drone, in the order of their numbers, its addresses and port
 */
public record AddressPlan(List<List<InetSocketAddress>> drones) {

  /** Ports that operator programs need for themselves. Documented: SDK 1.3 User Guide. */
  private static final Set<Integer> OPERATORS_PORTS = Set.of(8889, 8890, 11111);

  private static final int HIGHEST_PORT = 65535;

  /** Groups and reserved addresses begin with this and higher bytes. Documented: RFC 1112. */
  private static final int FIRST_GROUP = 224;

  /** One address a drone, all on the same port. */
  public static AddressPlan of(List<InetAddress> addresses, int port) {
    return new AddressPlan(
        addresses.stream().map(address -> List.of(new InetSocketAddress(address, port))).toList());
  }

  /**
   * The first drone on all addresses of this machine, the others on 127.0.0.2 and so on, all on the
   * same port.
   */
  public static AddressPlan ofMachine(int drones, int port) {
    return ofMachine(
        Collections.nCopies(drones, Optional.empty()), Collections.nCopies(drones, port));
  }

  /**
   * The same, but for drones whose address is given.
   *
   * @param given for each drone its address; empty for the usual ones of its number
   * @param ports for each drone its port
   */
  public static AddressPlan ofMachine(List<Optional<InetAddress>> given, List<Integer> ports) {
    List<InetSocketAddress> others = new ArrayList<>();
    for (int number = 2; number <= given.size(); number++) {
      InetAddress usual = loopback(number);
      others.add(new InetSocketAddress(given.get(number - 1).orElse(usual), ports.get(number - 1)));
    }
    List<InetAddress> wanted = given.get(0).map(List::of).orElseGet(AddressPlan::machineAddresses);
    List<InetSocketAddress> first = new ArrayList<>(onPort(wanted, ports.get(0)));
    if (given.get(0).isEmpty()) {
      first.removeAll(others); // where they had to be added, the machine counts them among its own
    }
    List<List<InetSocketAddress>> plan = new ArrayList<>();
    plan.add(first);
    others.forEach(other -> plan.add(List.of(other)));
    return new AddressPlan(plan);
  }

  /**
   * All drones on the same addresses, each on a port of its own from {@code firstPort} on.
   *
   * @throws IllegalArgumentException with a sentence, if there are not enough ports
   */
  public static AddressPlan portPerDrone(int drones, List<InetAddress> addresses, int firstPort) {
    List<List<InetSocketAddress>> plan = new ArrayList<>();
    int port = firstPort;
    for (int number = 1; number <= drones; number++) {
      while (number > 1 && OPERATORS_PORTS.contains(port)) {
        port++;
      }
      if (port > HIGHEST_PORT) {
        throw new IllegalArgumentException(
            String.format(
                Locale.ROOT,
                "there are no ports for %d drones from port %d on",
                drones,
                firstPort));
      }
      plan.add(onPort(addresses, port));
      port += firstPort == 0 ? 0 : 1;
    }
    return new AddressPlan(plan);
  }

  /**
   * Whether it is not the address of a group (multicast), of everybody, or reserved for neither.
   */
  public static boolean isOfOneHost(InetAddress address) {
    return (address.getAddress()[0] & 0xff) < FIRST_GROUP;
  }

  /** Every IPv4 address of this machine, loopback first. */
  public static List<InetAddress> machineAddresses() {
    List<InetAddress> addresses = new ArrayList<>();
    addresses.add(loopback(1));
    try {
      NetworkInterface.networkInterfaces()
          .flatMap(NetworkInterface::inetAddresses)
          .filter(address -> address instanceof Inet4Address && !addresses.contains(address))
          .forEach(addresses::add);
    } catch (SocketException e) {
      return addresses;
    }
    return addresses;
  }

  private static List<InetSocketAddress> onPort(List<InetAddress> addresses, int port) {
    return addresses.stream().map(address -> new InetSocketAddress(address, port)).toList();
  }

  private static InetAddress loopback(int last) {
    try {
      return InetAddress.getByAddress(new byte[] {127, 0, 0, (byte) last});
    } catch (UnknownHostException e) {
      throw new IllegalStateException("four bytes are an address", e);
    }
  }
}
