package tellosimulator.launcher;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * A private network that consists of two linked network stacks: one has the addresses of the
 * drones, the other has the address of the machine that controls them. The stacks are Linux
 * namespaces, which an ordinary user may create where the system permits it. They disappear when
 * the last process in them has ended. The program also has a PID namespace. When the program ends,
 * the kernel kills all processes in this namespace, even those that have tried to detach
 * themselves. Not thread-safe.
 */
final class OperatorNetwork implements ProgramNetwork {

  /** Address of a single drone in its own network. Documented: SDK 2.0 User Guide. */
  private static final String DRONE = "192.168.10.1";

  /**
   * Address of the machine that has joined the drone's network. Measured: the first address that a
   * drone assigns.
   */
  private static final String PROGRAM = "192.168.10.2";

  /**
   * Difference between the last byte of a drone's address in a swarm and the drone's number.
   * Decided: gives the same addresses as the TelloSwarm examples.
   */
  private static final int SWARM = 10;

  /**
   * Maximum number of drones with an address. Decided: fewer than the 244 addresses from
   * 192.168.10.11 to 192.168.10.254.
   */
  static final int MOST_DRONES = 240;

  /**
   * The first process of the program's PID namespace. It starts the program. After the program has
   * ended, it sends TERM to the remaining processes and waits up to 2 s for them. When it ends, the
   * kernel kills all remaining processes. Like the first process of any PID namespace, it ignores
   * signals for which it has no handler, except KILL and STOP from outside the namespace.
   */
  private static final String INIT =
      """
      [ $$ -eq 1 ] || exit 125 # it ends all processes that it sees
      mount -t proc proc /proc 2> /dev/null # or the program would see its process under another id
      "$@"
      code=$?
      tenths=0
      kill -s TERM -- -1 2> /dev/null
      while [ $tenths -lt 20 ] && kill -s 0 -- -1 2> /dev/null; do
        sleep 0.1
        tenths=$((tenths + 1))
      done
      exit $code
      """;

  /**
   * The command prefix that creates a PID namespace. The namespace ends with the process that the
   * prefix starts.
   */
  private static final List<String> OWN_PROCESSES =
      words("setsid unshare --pid --mount --fork --kill-child --");

  /**
   * The user ids of a namespace that real root creates: those of the system, so that a program can
   * run as another user. Documented: user_namespaces(7).
   */
  private static final String ALL_IDS = "0 0 65535";

  /** Command port of real drones. Documented: SDK 1.3 User Guide. */
  static final String COMMAND_PORT = "8889";

  private final Namespace drones;
  private final Namespace program;
  private final List<String> addresses;

  private OperatorNetwork(Namespace drones, Namespace program, int count) {
    this.drones = drones;
    this.program = program;
    this.addresses = addresses(count);
  }

  /** Returns the addresses for a number of drones. */
  static List<String> addresses(int drones) {
    return drones == 1
        ? List.of(DRONE)
        : IntStream.rangeClosed(1, drones).mapToObj(i -> "192.168.10." + (SWARM + i)).toList();
  }

  /**
   * Creates a network.
   *
   * @param drones the number of drones with an address
   * @throws UnavailableException if this system does not permit private networks; the message is
   *     one sentence
   */
  static OperatorNetwork create(int drones) throws UnavailableException, InterruptedException {
    Namespace own = Namespace.withOwnUsers();
    try {
      Namespace other = Namespace.create(ProgramRun.joined(own.command(), words("unshare --net")));
      OperatorNetwork network = new OperatorNetwork(own, other, drones);
      try {
        network.connect();
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

  private void connect() throws UnavailableException, InterruptedException {
    drones.run("ip link set lo up");
    program.run("ip link set lo up");
    drones.run("ip link add drone type veth peer name program netns " + program.pid);
    for (String address : addresses) {
      drones.run("ip address add " + address + "/24 dev drone");
    }
    program.run("ip address add " + PROGRAM + "/24 dev program");
    drones.run("ip link set drone up");
    program.run("ip link set program up");
    program.run(String.join(" ", OWN_PROCESSES) + " true");
  }

  /** Wraps a command to run in the drones' namespace, isolated from the terminal's Ctrl-C. */
  @Override
  public List<String> simulator(List<String> command) {
    List<String> listening =
        List.of("--bind", String.join(",", addresses), "--command-port", COMMAND_PORT);
    List<String> isolated = ProgramRun.joined(List.of("setsid"), command);
    return drones.with("TERM", ProgramRun.joined(isolated, listening));
  }

  /**
   * Wraps a command to run in the operator program's namespace, isolated from the terminal's
   * Ctrl-C. The started process has one child, which starts the command. When the started process
   * or this program ends, all processes in the PID namespace end as well.
   */
  @Override
  public List<String> program(List<String> command, Optional<Confinement> confinement) {
    return started(
        confinement
            .map(each -> each.wrapped(List.of(), command))
            .orElseGet(() -> ProgramRun.joined(List.of("sh", "-c", INIT, "run"), command)));
  }

  /** Wraps a command to become the first process of a PID namespace. */
  List<String> started(List<String> init) {
    return program.with("KILL", ProgramRun.joined(OWN_PROCESSES, init));
  }

  @Override
  public boolean ownsProcesses() {
    return true;
  }

  @Override
  public Map<String, String> variables(String ready) {
    return Map.of(); // the drones have the addresses of real ones
  }

  private static List<String> words(String command) {
    return List.of(command.split(" ", -1));
  }

  /** Releases the network, which disappears when all processes in it have ended. */
  @Override
  public void close() {
    program.close();
    drones.close();
  }

  /** A network namespace. It is kept alive by a process that ends when this program ends. */
  private static final class Namespace implements AutoCloseable {

    private final Process keeper;
    private final long pid;

    private Namespace(Process keeper, long pid) {
      this.keeper = keeper;
      this.pid = pid;
    }

    /**
     * Creates a network namespace with users of its own. For an ordinary user, root is the only
     * user in it; for real root, all users exist.
     */
    static Namespace withOwnUsers() throws UnavailableException {
      List<String> alone = words("unshare --user --map-root-user --net");
      if (!isRoot()) {
        return create(alone);
      }
      Namespace all = create(words("unshare --user --net"));
      try {
        for (String map : List.of("uid_map", "gid_map")) {
          Path file = Path.of("/proc", Long.toString(all.pid), map);
          Files.writeString(file, ALL_IDS, StandardOpenOption.WRITE);
        }
        return all;
      } catch (IOException e) {
        all.close();
        return create(alone); // in a container without these users
      }
    }

    private static boolean isRoot() {
      try {
        return Integer.valueOf(0).equals(Files.getAttribute(Path.of("/proc/self"), "unix:uid"));
      } catch (IOException | UnsupportedOperationException e) {
        return false;
      }
    }

    /**
     * Creates a namespace.
     *
     * @param unshare the command prefix that creates the namespace and starts another command in it
     */
    static Namespace create(List<String> unshare) throws UnavailableException {
      List<String> waiting = List.of("sh", "-c", "echo $$; exec cat");
      try {
        Process keeper = new ProcessBuilder(ProgramRun.joined(unshare, waiting)).start();
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
      return words("nsenter --target " + pid + " --user --net --preserve-credentials --");
    }

    /**
     * Wraps a command to run in this namespace.
     *
     * @param signal the signal that the command receives if this program is killed
     */
    List<String> with(String signal, List<String> command) {
      List<String> inherit = words("setpriv --pdeathsig " + signal + " --");
      return ProgramRun.joined(command(), ProgramRun.joined(inherit, command));
    }

    /** Runs a command whose words contain no spaces. */
    void run(String command) throws UnavailableException, InterruptedException {
      try {
        Process process =
            new ProcessBuilder(with("TERM", words(command))).redirectErrorStream(true).start();
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
