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
 * ended. The program has a PID namespace, too, whose end the kernel makes the end of all processes
 * in it, whatever they did to be left alone. For one thread.
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

  /**
   * The first process of the program's PID namespace. It starts the program, and when that has
   * ended sends TERM to what the program has left running, and waits for it, for 2 s; with itself
   * it ends all others. It ignores signals, as first processes do.
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

  /** The words that give a command a PID namespace, which ends with the process that they start. */
  private static final List<String> OWN_PROCESSES =
      List.of("setsid", "unshare", "--pid", "--mount", "--fork", "--kill-child", "--");

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
    program.run(joined(OWN_PROCESSES, List.of("true")).toArray(String[]::new));
  }

  /** The words that start a command where the drones are, out of reach of the terminal's Ctrl-C. */
  List<String> whereDronesAre(List<String> command) {
    return drones.with("TERM", joined(List.of("setsid"), command));
  }

  /**
   * The words that start a command where the operator program is, out of reach of the terminal's
   * Ctrl-C. The process that they start has one child, which starts the command; when that process
   * ends, or this program does, so do all that have come from it.
   */
  List<String> whereTheProgramIs(List<String> command) {
    List<String> init = List.of("sh", "-c", INIT, "run");
    return program.with("KILL", joined(OWN_PROCESSES, joined(init, command)));
  }

  private static List<String> joined(List<String> first, List<String> second) {
    return Stream.of(first, second).flatMap(List::stream).toList();
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

    /**
     * The words that start a command in it.
     *
     * @param signal that it gets if this program is killed
     */
    List<String> with(String signal, List<String> command) {
      List<String> inherit = List.of("setpriv", "--pdeathsig", signal, "--");
      return joined(command(), joined(inherit, command));
    }

    void run(String... command) throws UnavailableException, InterruptedException {
      try {
        Process process =
            new ProcessBuilder(with("TERM", List.of(command))).redirectErrorStream(true).start();
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
