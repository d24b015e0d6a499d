package tellosimulator.operator;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Two network stacks with a link between them, seen by nobody else: one has the addresses of
 * drones, the other that of the machine that flies them. They are Linux namespaces, which an
 * ordinary user may make where the system lets him; they are gone when the last process in them has
 * ended. For one thread.
 */
final class OperatorNetwork implements AutoCloseable {

  /** Of a drone in its own network. Documented: SDK 2.0 User Guide. */
  private static final String DRONE = "192.168.10.1";

  /** Of who has joined it. Measured: the first address that a drone gives. */
  private static final String PROGRAM = "192.168.10.2";

  /** Last byte of the first address in a swarm, one less. Decided: as TelloSwarm examples have. */
  private static final int SWARM = 10;

  /** Drones that have an address. Decided: those of the network that are left. */
  static final int MOST_DRONES = 240;

  private final Namespace drones;
  private final Namespace program;

  private OperatorNetwork(Namespace drones, Namespace program) {
    this.drones = drones;
    this.program = program;
  }

  /** Addresses of so many drones. */
  static List<String> addresses(int drones) {
    return drones == 1
        ? List.of(DRONE)
        : IntStream.rangeClosed(1, drones).mapToObj(i -> "192.168.10." + (SWARM + i)).toList();
  }

  /**
   * Makes one.
   *
   * @param drones how many have an address
   * @throws UnavailableException with a sentence, if this system does not let one
   */
  static OperatorNetwork create(int drones) throws UnavailableException, InterruptedException {
    Namespace own = Namespace.create(List.of("unshare", "--user", "--map-root-user", "--net"));
    try {
      List<String> within = new ArrayList<>(own.command());
      within.addAll(List.of("unshare", "--net"));
      Namespace other = Namespace.create(within);
      OperatorNetwork network = new OperatorNetwork(own, other);
      try {
        network.connect(drones);
        return network;
      } catch (UnavailableException | InterruptedException | RuntimeException e) {
        other.close();
        throw e;
      }
    } catch (UnavailableException | InterruptedException | RuntimeException e) {
      own.close();
      throw e;
    }
  }

  private void connect(int count) throws UnavailableException, InterruptedException {
    drones.run("ip", "link", "set", "lo", "up");
    program.run("ip", "link", "set", "lo", "up");
    drones.run(
        "ip",
        "link",
        "add",
        "drone",
        "type",
        "veth",
        "peer",
        "name",
        "program",
        "netns",
        Long.toString(program.pid));
    for (String address : addresses(count)) {
      drones.run("ip", "address", "add", address + "/24", "dev", "drone");
    }
    program.run("ip", "address", "add", PROGRAM + "/24", "dev", "program");
    drones.run("ip", "link", "set", "drone", "up");
    program.run("ip", "link", "set", "program", "up");
  }

  /** The words that start a command where the drones are. */
  List<String> whereDronesAre(List<String> command) {
    return drones.with(command);
  }

  /** The words that start a command where the operator program is. */
  List<String> whereTheProgramIs(List<String> command) {
    return program.with(command);
  }

  /** Lets go of it; it is gone when the processes in it have ended, too. */
  @Override
  public void close() {
    program.close();
    drones.close();
  }

  /** A network namespace, which a process keeps that waits for the end of this one. */
  private static final class Namespace implements AutoCloseable {

    private final Process keeper;
    private final long pid;

    private Namespace(Process keeper, long pid) {
      this.keeper = keeper;
      this.pid = pid;
    }

    /**
     * Makes one.
     *
     * @param unshare the command that does, and then starts another one in it
     */
    static Namespace create(List<String> unshare) throws UnavailableException {
      List<String> command = new ArrayList<>(unshare);
      command.addAll(List.of("sh", "-c", "echo $$; exec cat"));
      try {
        Process keeper = new ProcessBuilder(command).start();
        String pid = keeper.inputReader().readLine();
        if (pid == null) {
          throw UnavailableException.because(keeper.errorReader().readLine());
        }
        return new Namespace(keeper, Long.parseLong(pid));
      } catch (IOException e) {
        throw UnavailableException.because(e.getMessage());
      }
    }

    private List<String> command() {
      return List.of(
          "nsenter",
          "--target",
          Long.toString(pid),
          "--user",
          "--net",
          "--preserve-credentials",
          "--");
    }

    /** The words that start a command in it, which is told to end if this program is killed. */
    List<String> with(List<String> command) {
      return Stream.of(command(), List.of("setpriv", "--pdeathsig", "TERM", "--"), command)
          .flatMap(List::stream)
          .toList();
    }

    void run(String... command) throws UnavailableException, InterruptedException {
      try {
        Process process =
            new ProcessBuilder(with(List.of(command))).redirectErrorStream(true).start();
        String said = process.inputReader().readLine();
        if (process.waitFor() != 0) {
          throw UnavailableException.because(said);
        }
      } catch (IOException e) {
        throw UnavailableException.because(e.getMessage());
      }
    }

    @Override
    public void close() {
      keeper.destroy();
    }
  }
}
