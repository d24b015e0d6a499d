package tellosimulator.network;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import tellosimulator.sim.SimConfig.StreamPorts;

/**
 * The listen addresses requested for each drone. The machine's actual addresses are looked up when
 * the sockets are opened. Immutable.
 *
 * @param drones the endpoint of each drone, in the order of drone numbers
 * @param reach determines which of the machine's own addresses are used
 */
public record AddressPlan(List<Endpoint> drones, Reach reach) {

  /**
   * The command port of real drones, and the port where operator programs receive replies.
   * Documented: SDK 1.3 User Guide.
   */
  public static final int REAL_COMMAND_PORT = 8889;

  /** Ports that operator programs bind. */
  private static final Set<Integer> OPERATORS_PORTS =
      Set.of(REAL_COMMAND_PORT, StreamPorts.DEFAULT.statePort(), StreamPorts.DEFAULT.videoPort());

  /** Highest UDP port. Documented: RFC 768; ports have 16 bits. */
  public static final int HIGHEST_PORT = 65535;

  /** Maximum number of drones: one for each of 127.0.0.1 to 127.0.0.250. Decided. */
  public static final int MOST_DRONES = 250;

  /**
   * The lowest first byte of multicast addresses. Reserved addresses begin with higher bytes.
   * Documented: RFC 1112.
   */
  private static final int FIRST_GROUP = 224;

  private static final Pattern DOTTED =
      Pattern.compile("((25[0-5]|2[0-4][0-9]|[01]?[0-9]?[0-9])(\\.(?!$)|$)){4}");

  /**
   * The listen addresses and port of one drone.
   *
   * @param addresses fixed addresses; empty for the machine's own addresses, as selected by the
   *     {@link Reach}
   * @param port the port on all addresses; 0 lets the system choose
   * @param bound whether a user requested these addresses explicitly; if so, they are opened even
   *     if they are reachable from the network
   */
  public record Endpoint(List<InetAddress> addresses, int port, boolean bound) {

    public Endpoint {
      addresses = List.copyOf(addresses);
    }

    boolean ofMachine() {
      return addresses.isEmpty();
    }
  }

  public AddressPlan {
    drones = List.copyOf(drones);
  }

  /** Creates a plan for programs on this machine. */
  public AddressPlan(List<Endpoint> drones) {
    this(drones, Reach.THIS_MACHINE);
  }

  /** Returns a copy of this plan with another reach. */
  public AddressPlan withReach(Reach newReach) {
    return new AddressPlan(drones, newReach);
  }

  /** Returns a plan with one address for each drone, all on the same port. */
  public static AddressPlan of(List<InetAddress> addresses, int port) {
    return new AddressPlan(
        addresses.stream().map(address -> new Endpoint(List.of(address), port, true)).toList());
  }

  /**
   * Returns a plan with the first drone on the machine's own addresses and the others on 127.0.0.2
   * and so on, all on the same port.
   */
  public static AddressPlan ofMachine(int drones, int port) {
    return ofMachine(
        Collections.nCopies(drones, Optional.empty()), Collections.nCopies(drones, port));
  }

  /**
   * Returns a plan like {@link #ofMachine(int, int)}, except for drones whose address a scenario
   * sets.
   *
   * @param given the address of each drone; empty for the default address for its number
   * @param ports the port of each drone
   */
  public static AddressPlan ofMachine(List<Optional<InetAddress>> given, List<Integer> ports) {
    List<Endpoint> plan = new ArrayList<>();
    for (int number = 1; number <= given.size(); number++) {
      Optional<InetAddress> usual = number == 1 ? Optional.empty() : Optional.of(loopback(number));
      List<InetAddress> addresses =
          given.get(number - 1).or(() -> usual).map(List::of).orElse(List.of());
      plan.add(new Endpoint(addresses, ports.get(number - 1), false));
    }
    return new AddressPlan(plan);
  }

  /**
   * Returns a plan with all drones on the same addresses, each on its own port. The ports count up
   * from {@code firstPort}, leaving out those that operator programs bind.
   *
   * @param addresses the addresses; empty for the machine's own
   * @param firstPort the port of drone 1; 0 lets the system choose all ports
   * @throws IllegalArgumentException if there are not enough ports; the message is one sentence
   */
  public static AddressPlan portPerDrone(int drones, List<InetAddress> addresses, int firstPort) {
    List<Endpoint> plan = new ArrayList<>();
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
      plan.add(new Endpoint(addresses, port, !addresses.isEmpty()));
      port += firstPort == 0 ? 0 : 1;
    }
    return new AddressPlan(plan);
  }

  /** Parses the IPv4 address of a single host, without looking up names; empty for other texts. */
  public static Optional<InetAddress> parse(String dotted) {
    try {
      return DOTTED.matcher(dotted).matches()
          ? Optional.of(InetAddress.getByName(dotted)).filter(AddressPlan::isOfOneHost)
          : Optional.empty();
    } catch (UnknownHostException e) {
      throw new IllegalArgumentException(dotted + " is no address", e);
    }
  }

  /**
   * Returns whether an address belongs to a single host. The wildcard (0.0.0.0), multicast groups,
   * the broadcast address and reserved addresses do not.
   */
  public static boolean isOfOneHost(InetAddress address) {
    int first = address.getAddress()[0] & 0xff;
    return first > 0 && first < FIRST_GROUP;
  }

  /**
   * Returns the addresses where a drone listens on this machine. Leaves out machine addresses that
   * are assigned to another drone, such as 127.0.0.2 on systems where this address had to be added.
   *
   * @param drone the drone's number, from 1
   * @param networks the machine's addresses
   */
  public List<InetSocketAddress> addresses(int drone, LocalNetworks networks) {
    Endpoint endpoint = drones.get(drone - 1);
    if (!endpoint.ofMachine()) {
      return at(endpoint.addresses(), endpoint.port());
    }
    List<InetAddress> own = reach == Reach.NETWORK ? networks.addresses() : List.of(loopback(1));
    List<InetSocketAddress> addresses = new ArrayList<>(at(own, endpoint.port()));
    for (Endpoint other : drones) {
      addresses.removeAll(at(other.addresses(), other.port()));
    }
    return addresses.isEmpty() ? at(own, endpoint.port()) : List.copyOf(addresses);
  }

  /**
   * Returns whether a drone may listen at an address. Addresses reachable from the network are
   * allowed only on request.
   */
  boolean allows(int drone, InetAddress address) {
    return address.isLoopbackAddress() || reach == Reach.NETWORK || drones.get(drone - 1).bound();
  }

  /** Returns a copy of this plan with another port for one drone. */
  AddressPlan withPort(int drone, int port) {
    return new AddressPlan(
        IntStream.rangeClosed(1, drones.size())
            .mapToObj(
                number -> {
                  Endpoint endpoint = drones.get(number - 1);
                  return number == drone
                      ? new Endpoint(endpoint.addresses(), port, endpoint.bound())
                      : endpoint;
                })
            .toList(),
        reach);
  }

  private static List<InetSocketAddress> at(List<InetAddress> addresses, int port) {
    return addresses.stream().map(address -> new InetSocketAddress(address, port)).toList();
  }

  static InetAddress loopback(int last) {
    try {
      return InetAddress.getByAddress(new byte[] {127, 0, 0, (byte) last});
    } catch (UnknownHostException e) {
      throw new IllegalStateException("four bytes are an address", e);
    }
  }
}
