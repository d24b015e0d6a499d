package tellosimulator.operator;

import java.io.BufferedReader;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
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

  /**
   * How long a verdict may take once the program has ended [s]. Decided: a drone that was left in
   * the air lands by itself after 15 s, and 15 s later it is over; where no drone was ever asked
   * for anything, nothing would come for ever.
   */
  private static final int VERDICT_SECONDS = 90;

  /** How long a program may take to end when it is told to [s]. Decided. */
  private static final int GRACE_SECONDS = 2;

  private final Plan plan;
  private final PrintStream out;
  private final int verdictSeconds;
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
    this(plan, out, VERDICT_SECONDS);
  }

  /**
   * @param verdictSeconds how long a verdict may take once the program has ended
   */
  ProgramRun(Plan plan, PrintStream out, int verdictSeconds) {
    this.verdictSeconds = verdictSeconds;
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
    switch (plan.ends()) {
      case AT_ONCE -> quit(started);
      case WITH_VERDICT -> {
        if (!started.waitFor(verdictSeconds, TimeUnit.SECONDS)) {
          quit(started);
        }
      }
      case WITH_WINDOW ->
          out.println("The program has ended; close the window to end the simulator, too.");
    }
    return started.waitFor();
  }

  private static void quit(Process started) {
    try (BufferedWriter console = started.outputWriter()) {
      console.write("quit\n");
    } catch (IOException e) {
      started.destroy(); // it takes nothing any more
    }
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

  /** Ends both, wherever they are, also a program that does not want to. */
  @Override
  public void close() {
    simulator.ifPresent(Process::destroy);
    program.ifPresent(ProgramRun::terminate);
  }

  private static void terminate(Process process) {
    List<ProcessHandle> all =
        Stream.concat(Stream.of(process.toHandle()), process.descendants()).toList();
    process.destroy();
    try {
      process.waitFor(GRACE_SECONDS, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    all.forEach(ProcessHandle::destroyForcibly);
  }
}
