package tellosimulator.operator;

import java.io.BufferedReader;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.lang.ProcessBuilder.Redirect;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Stream;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;

/**
 * A simulator and an operator program, each a process of its own in a {@link OperatorNetwork}: the
 * program finds drones where real ones are, with the ports of real ones. The flight ends with the
 * program: then the simulator lands the drones, gives its verdict and ends. What the simulator
 * writes is passed on. {@link #run} works on the calling thread; the other methods are for any.
 */
public final class ProgramRun implements AutoCloseable {

  /** Longest time after which the end of the simulator is noticed [ms]. Decided. */
  private static final long NOTICE_MS = 50;

  /** With which a simulator says that it is ready. */
  private static final String READY = "ready";

  /** Where real drones take commands. Documented: SDK 1.3 User Guide. */
  private static final String COMMAND_PORT = "8889";

  /**
   * How long a simulator may take to land its drones, and then to end [s]. Decided: a landing from
   * 10 m takes 20 s, and a report some seconds.
   */
  private static final int LANDING_SECONDS = 60;

  /**
   * How long a program that was interrupted may take to land its drones [s]. Decided: djitellopy
   * waits 7 s for a reply, and lands then.
   */
  private static final int INTERRUPTED_SECONDS = 20;

  /** How long a program may take to end after TERM [s]. Decided. */
  private static final int GRACE_SECONDS = 2;

  private final Plan plan;
  private final PrintStream out;
  private final AtomicBoolean interrupted = new AtomicBoolean();
  private volatile Optional<Process> simulator = Optional.empty();
  private volatile Optional<Process> program = Optional.empty();
  private volatile boolean terminated;

  /**
   * What is run.
   *
   * @param simulator the words that start a simulator, but for where it listens
   * @param program the words that start the operator program
   * @param drones how many there are, at most {@link #MOST_DRONES}
   * @param window whether the simulator has a window, which stays open when the program has ended
   * @param output the file for what the program writes; empty if it writes where this program does
   */
  public record Plan(
      List<String> simulator,
      List<String> program,
      int drones,
      boolean window,
      Optional<Path> output) {

    public Plan {
      simulator = List.copyOf(simulator);
      program = List.copyOf(program);
    }
  }

  /** How many drones there can be. */
  public static final int MOST_DRONES = OperatorNetwork.MOST_DRONES;

  /**
   * How it ended.
   *
   * @param program exit code of the operator program; empty if it did not end by itself
   * @param simulator exit code of the simulator
   */
  public record ExitCodes(OptionalInt program, int simulator) {}

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
      Process flown = startSimulator(network);
      try (BufferedReader lines = flown.inputReader()) {
        if (!awaitReady(lines)) {
          flown.waitFor();
          return Optional.empty();
        }
        try (Worker passing = Worker.start("simulator-output", new Passing(lines))) {
          ExitCodes codes = runProgram(network, flown);
          passing.end();
          return Optional.of(codes);
        }
      }
    } finally {
      close();
    }
  }

  private Process startSimulator(OperatorNetwork network) throws IOException {
    Process flown =
        new ProcessBuilder(network.whereDronesAre(simulatorCommand()))
            .redirectError(Redirect.INHERIT)
            .start();
    simulator = Optional.of(flown);
    if (interrupted.get()) {
      flown.destroy();
    }
    return flown;
  }

  private List<String> simulatorCommand() {
    List<String> command = new ArrayList<>(plan.simulator());
    command.add("--bind");
    command.add(String.join(",", OperatorNetwork.addresses(plan.drones())));
    command.add("--command-port");
    command.add(COMMAND_PORT);
    return command;
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

  private ExitCodes runProgram(OperatorNetwork network, Process flown)
      throws IOException, InterruptedException {
    ProcessBuilder builder =
        new ProcessBuilder(network.whereTheProgramIs(plan.program())).inheritIO();
    if (plan.output().isEmpty()) {
      return end(builder.start(), flown);
    }
    try (OutputStream file = Files.newOutputStream(plan.output().get())) {
      Process flying = builder.redirectErrorStream(true).redirectOutput(Redirect.PIPE).start();
      try (Worker writing =
          Worker.start("program-output", new BoundedCopy(flying.getInputStream(), file))) {
        ExitCodes codes = end(flying, flown);
        writing.end();
        return codes;
      }
    }
  }

  /** Waits until one has ended, and ends the other. */
  private ExitCodes end(Process flying, Process flown) throws InterruptedException {
    program = Optional.of(flying);
    while (flown.isAlive() && !flying.waitFor(NOTICE_MS, TimeUnit.MILLISECONDS)) {
      // both run
    }
    if (flying.isAlive()) {
      terminate(flying);
    }
    int code = flying.waitFor();
    OptionalInt own = terminated ? OptionalInt.empty() : OptionalInt.of(code);
    out.println("program: " + (terminated ? "ended by run" : "exit code " + code));
    return new ExitCodes(own, finish(flown));
  }

  /** Ends a simulator whose program has ended. */
  private int finish(Process flown) throws InterruptedException {
    if (plan.window()) {
      if (interrupted.get()) {
        flown.destroy();
      } else if (flown.isAlive()) {
        out.println("The program has ended; close the window to end the simulator, too.");
      }
      return flown.waitFor();
    }
    if (!ends(flown, "finish") && !ends(flown, "quit")) {
      flown.destroyForcibly();
    }
    return flown.waitFor();
  }

  private static boolean ends(Process flown, String word) throws InterruptedException {
    BufferedWriter console = flown.outputWriter();
    try {
      console.write(word + "\n");
      console.flush();
    } catch (IOException e) {
      flown.destroy(); // it takes nothing any more
    }
    return flown.waitFor(LANDING_SECONDS, TimeUnit.SECONDS);
  }

  /** Passes on what a simulator says, until it has ended. */
  private final class Passing implements Agent {

    private final BufferedReader lines;

    private Passing(BufferedReader lines) {
      this.lines = lines;
    }

    @Override
    public Outcome doWork() throws IOException {
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        out.println(line); // to the end, or the last lines are lost when the worker is ended
      }
      return Outcome.FINISHED;
    }

    @Override
    public ErrorPolicy onError(Throwable failure) {
      return ErrorPolicy.finish("What the simulator says is not passed on any more");
    }
  }

  /** Whether {@link #interrupt} was called. */
  boolean interrupted() {
    return interrupted.get();
  }

  /**
   * Interrupts the program, as Ctrl-C does, and waits until it has ended or its time is over; the
   * simulator stays until then. The second call kills both at once.
   */
  public void interrupt() throws InterruptedException {
    if (interrupted.getAndSet(true)) {
      program.filter(Process::isAlive).ifPresent(this::kill);
      simulator.ifPresent(Process::destroyForcibly);
    } else if (program.isPresent() && program.get().isAlive()) {
      interrupt(program.get());
    } else if (program.isEmpty() || plan.window()) {
      simulator.ifPresent(Process::destroy);
    }
  }

  private void interrupt(Process flying) throws InterruptedException {
    List<String> command = new ArrayList<>(List.of("sh", "-c", "kill -s INT \"$@\"", "kill"));
    started(flying).forEach(process -> command.add(Long.toString(process.pid())));
    try {
      new ProcessBuilder(command).start().waitFor();
      if (flying.waitFor(INTERRUPTED_SECONDS, TimeUnit.SECONDS)) {
        return;
      }
    } catch (IOException e) {
      out.println("The program cannot be interrupted, and is ended: " + e.getMessage());
    }
    terminate(flying);
  }

  /** Ends both, wherever they are, also a program that does not want to. */
  @Override
  public void close() {
    simulator.ifPresent(Process::destroy);
    program.filter(Process::isAlive).ifPresent(this::terminate);
  }

  private void terminate(Process flying) {
    terminated = true;
    started(flying).forEach(ProcessHandle::destroy);
    try {
      flying.waitFor(GRACE_SECONDS, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    kill(flying);
  }

  /** The program and all that has come from it. */
  private static Stream<ProcessHandle> started(Process flying) {
    return flying.children().flatMap(ProcessHandle::descendants);
  }

  /** Ends the first process of the namespace, and so all others. */
  private void kill(Process flying) {
    terminated = true;
    List<ProcessHandle> first = flying.children().toList();
    flying.destroyForcibly(); // or unshare of util-linux 2.38 complains
    first.forEach(ProcessHandle::destroyForcibly);
  }
}
