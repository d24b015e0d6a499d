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
import java.util.stream.IntStream;
import tellosimulator.sim.SimConfig.StreamPorts;

/**
 * The requested listen address of each drone; the machine's actual addresses are looked up when
 * sockets are opened. Immutable; for any thread.
 *
 * @param drones for each drone, in the order of their numbers, where it listens
 * @param reach how far the machine's own addresses go
 */
public record AddressPlan(List<Endpoint> drones, Reach reach) {

  /**
   * Where real drones take commands, and where operator programs take the replies. Documented: SDK
   * 1.3 User Guide.
   */
  public static final int REAL_COMMAND_PORT = 8889;

  /** Ports that operator programs need for themselves. */
  private static final Set<Integer> OPERATORS_PORTS =
      Set.of(REAL_COMMAND_PORT, StreamPorts.DEFAULT.statePort(), StreamPorts.DEFAULT.videoPort());

  /** Highest port of UDP. Documented: RFC 768, whose ports have 16 bits. */
  public static final int HIGHEST_PORT = 65535;

  /** As many as 127.0.0.1 to 127.0.0.250. Decided. */
  public static final int MOST_DRONES = 250;

  /** Groups and reserved addresses begin with this and higher bytes. Documented: RFC 1112. */
  private static final int FIRST_GROUP = 224;

  /**
   * Where one drone listens.
   *
   * @param addresses fixed ones; empty for those of the machine, as far as the {@link Reach} goes
   * @param port on all of them; 0 for one that the system chooses
   * @param bound whether a person asked for these addresses, which are opened then even if the
   *     network reaches them
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

  /** For programs on this machine. */
  public AddressPlan(List<Endpoint> drones) {
    this(drones, Reach.THIS_MACHINE);
  }

  /** The same drones, reached from elsewhere. */
  public AddressPlan withReach(Reach newReach) {
    return new AddressPlan(drones, newReach);
  }

  /** One address a drone, all on the same port. */
  public static AddressPlan of(List<InetAddress> addresses, int port) {
    return new AddressPlan(
        addresses.stream().map(address -> new Endpoint(List.of(address), port, true)).toList());
  }

  /**
   * The first drone on the machine's own addresses, the others on 127.0.0.2 and so on, all on the
   * same port.
   */
  public static AddressPlan ofMachine(int drones, int port) {
    return ofMachine(
        Collections.nCopies(drones, Optional.empty()), Collections.nCopies(drones, port));
  }

  /**
   * The same, but for drones whose address a scenario gives.
   *
   * @param given for each drone its address; empty for the usual ones of its number
   * @param ports for each drone its port
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
   * All drones on the same addresses, each on a port of its own from {@code firstPort} on.
   *
   * @param addresses empty for the machine's own
   * @throws IllegalArgumentException with a sentence, if there are not enough ports
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

  /**
   * Whether it is the address of one host: not of all of this machine's networks (0.0.0.0), of a
   * group (multicast), of everybody, or reserved for neither.
   */
  public static boolean isOfOneHost(InetAddress address) {
    int first = address.getAddress()[0] & 0xff;
    return first > 0 && first < FIRST_GROUP;
  }

  /**
   * Where a drone listens on this machine. Of the machine's addresses, those that another drone has
   * for itself are left out, such as 127.0.0.2 where it had to be added.
   *
   * @param drone its number, from 1
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

  /** Whether a drone may listen there: what the network reaches only if a person asked for it. */
  boolean allows(int drone, InetAddress address) {
    return address.isLoopbackAddress() || reach == Reach.NETWORK || drones.get(drone - 1).bound();
  }

  /** The same with another port for a drone. */
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
