package tellosimulator.endurance;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A few machines on one switch, each a network name space of its own; Linux lets a user make them
 * without being root. The first machine is the switch too, and the simulator's. All are gone when
 * this is closed.
 */
final class PrivateNetwork implements AutoCloseable {

  private static final List<String> ANYBODY =
      List.of("unshare", "--user", "--map-root-user", "--net");

  private static final List<String> KEEPER = List.of("sh", "-c", "echo kept; exec cat");

  private final List<Program> captures = new ArrayList<>();
  private final List<Host> hosts = new ArrayList<>();

  /** All machines are there when it returns. */
  PrivateNetwork(int machines) throws IOException {
    try {
      Host first = add(capture(Host.HERE, ANYBODY));
      first.run("ip", "link", "set", "lo", "up");
      first.run("ip", "link", "add", "lan", "type", "bridge");
      first.run("ip", "address", "add", first.address() + "/24", "dev", "lan");
      first.run("ip", "link", "set", "lan", "up");
      for (int machine = 2; machine <= machines; machine++) {
        connect(machine);
      }
    } catch (IOException e) {
      close();
      throw e;
    }
  }

  private void connect(int machine) throws IOException {
    Host first = hosts.get(0);
    Program keeper = capture(first, List.of("unshare", "--net"));
    String port = "port" + machine;
    String owner = "" + keeper.process().pid();
    first.run("ip", "link", "add", port, "type", "veth", "peer", "name", "cable", "netns", owner);
    first.run("ip", "link", "set", port, "master", "lan", "up");
    Host host = add(keeper);
    host.run("ip", "link", "set", "lo", "up");
    host.run("ip", "address", "add", host.address() + "/24", "dev", "cable");
    host.run("ip", "link", "set", "cable", "up");
  }

  private Program capture(Host where, List<String> unshare) throws IOException {
    List<String> command = new ArrayList<>(unshare);
    command.addAll(KEEPER);
    Program keeper = where.start(command);
    captures.add(keeper);
    keeper.await("kept", 10);
    return keeper;
  }

  private Host add(Program keeper) {
    String owner = "" + keeper.process().pid();
    List<String> wayIn =
        List.of("nsenter", "--target", owner, "--user", "--net", "--preserve-credentials");
    Host host = new Host(wayIn, "10.77.0." + (hosts.size() + 1));
    hosts.add(host);
    return host;
  }

  /**
   * One of the machines.
   *
   * @param machine from 1
   */
  Host host(int machine) {
    return hosts.get(machine - 1);
  }

  /** Why there can be none here; empty if there can. */
  static Optional<String> obstacle() {
    try (PrivateNetwork network = new PrivateNetwork(2)) {
      network.host(2).run("ip", "-V");
      return Optional.empty();
    } catch (IOException e) {
      return Optional.of(String.valueOf(e.getMessage()));
    }
  }

  @Override
  public void close() {
    for (int i = captures.size() - 1; i >= 0; i--) {
      captures.get(i).close();
    }
  }
}
