package tellosimulator.operator;

import java.io.BufferedReader;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;

/**
 * A simulator and an operator program, each a process of its own in a {@link OperatorNetwork}: the
 * program finds drones where real ones are, with the ports of real ones. What both write is passed
 * on. {@link #run} works on the calling thread; {@link #close} is for any.
 */
public final class ProgramRun implements AutoCloseable {

  /** With which a simulator says that it is ready. */
  private static final String READY = "ready";

  /** Where real drones take commands. Documented: SDK 1.3 User Guide. */
  private static final String COMMAND_PORT = "8889";

  private final Plan plan;
  private final PrintStream out;
  private volatile Optional<Process> simulator = Optional.empty();
  private volatile Optional<Process> program = Optional.empty();

  /**
   * What is run.
   *
   * @param simulator the words that start a simulator, but for where it listens
   * @param program the words that start the operator program
   * @param drones how many there are, at most {@link #MOST_DRONES}
   * @param ends how the simulator ends once the program has ended
   */
  public record Plan(List<String> simulator, List<String> program, int drones, Ends ends) {

    public Plan {
      simulator = List.copyOf(simulator);
      program = List.copyOf(program);
    }
  }

  /** How a simulator ends once the program has ended. */
  public enum Ends {
    /** When it is told to. */
    AT_ONCE,
    /** By itself, when there is a verdict on the program. */
    WITH_VERDICT,
    /** When somebody closes its window. */
    WITH_WINDOW
  }

  /** How many drones there can be. */
  public static final int MOST_DRONES = OperatorNetwork.MOST_DRONES;

  /**
   * How it ended.
   *
   * @param program exit code of the operator program
   * @param simulator exit code of the simulator
   */
  public record ExitCodes(int program, int simulator) {}

  /**
   * Does nothing yet.
   *
   * @param out takes what the simulator says
   */
  public ProgramRun(Plan plan, PrintStream out) {
    this.plan = plan;
    this.out = out;
  }

  /**
   * Runs both, until both have ended.
   *
   * @return empty if the simulator did not start, which it has said
   * @throws UnavailableException with a sentence, if this system lets nobody have a private network
   * @throws IOException with a clause, if the program cannot be started
   */
  public Optional<ExitCodes> run() throws UnavailableException, IOException, InterruptedException {
    try (OperatorNetwork network = OperatorNetwork.create(plan.drones())) {
      Process started = start(network.whereDronesAre(simulatorCommand()), false);
      simulator = Optional.of(started);
      try (BufferedReader lines = started.inputReader()) {
        if (!awaitReady(lines)) {
          started.waitFor();
          return Optional.empty();
        }
        try (Worker passing = Worker.start("simulator-output", new Passing(lines))) {
          Process flying = start(network.whereTheProgramIs(plan.program()), true);
          program = Optional.of(flying);
          int code = flying.waitFor();
          ExitCodes codes = new ExitCodes(code, end(started));
          passing.end();
          return Optional.of(codes);
        }
      }
    } finally {
      close();
    }
  }

  private List<String> simulatorCommand() {
    List<String> command = new ArrayList<>(plan.simulator());
    command.add("--bind");
    command.add(String.join(",", OperatorNetwork.addresses(plan.drones())));
    command.add("--command-port");
    command.add(COMMAND_PORT);
    return command;
  }

  /**
   * @param itsOwn whether it reads and writes where this program does
   */
  private static Process start(List<String> command, boolean itsOwn) throws IOException {
    ProcessBuilder builder =
        new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT);
    return itsOwn ? builder.inheritIO().start() : builder.start();
  }

  private boolean awaitReady(BufferedReader lines) throws IOException {
    for (String line = lines.readLine(); line != null; line = lines.readLine()) {
      out.println(line);
      if (line.startsWith(READY)) {
        return true;
      }
    }
    return false;
  }

  private int end(Process started) throws InterruptedException {
    if (plan.ends() == Ends.AT_ONCE) {
      try (BufferedWriter console = started.outputWriter()) {
        console.write("quit\n");
      } catch (IOException e) {
        started.destroy(); // it takes nothing any more
      }
    } else if (plan.ends() == Ends.WITH_WINDOW) {
      out.println("The program has ended; close the window to end the simulator, too.");
    }
    return started.waitFor();
  }

  /** Passes on what a simulator says, until it has ended. */
  private final class Passing implements Agent {

    private final BufferedReader lines;

    private Passing(BufferedReader lines) {
      this.lines = lines;
    }

    @Override
    public Outcome doWork() throws IOException {
      String line = lines.readLine();
      if (line == null) {
        return Outcome.FINISHED;
      }
      out.println(line);
      return Outcome.WORKED;
    }

    @Override
    public ErrorPolicy onError(Throwable failure) {
      return ErrorPolicy.finish("What the simulator says is not passed on any more");
    }
  }

  /** Ends both, wherever they are. */
  @Override
  public void close() {
    program.ifPresent(Process::destroy);
    simulator.ifPresent(Process::destroy);
  }
}
