package tellosimulator.launcher;

import java.io.BufferedReader;
import java.io.BufferedWriter;
import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.lang.ProcessBuilder.Redirect;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Stream;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;

/**
 * Runs a simulator and an operator program, each in its own process, in an {@link OperatorNetwork}
 * or a {@link ShimNetwork}. The program finds drones at the addresses and ports of real ones. When
 * the program ends, the simulator lands the drones, prints its verdict and ends. The simulator's
 * output is passed on. {@link #run} works on the calling thread; the other methods are thread-safe.
 */
public final class ProgramRun implements AutoCloseable {

  /** Interval at which the run checks whether the simulator has ended [ms]. Decided. */
  private static final long NOTICE_MS = 50;

  private static final boolean WINDOWS = File.separatorChar == '\\';

  /** Beginning of the line in which a simulator reports that it is ready. */
  private static final String READY = "ready";

  /**
   * Maximum time for a simulator to land its drones and then end [s]. Decided: a landing from 10 m
   * takes 20 s, and a report takes several seconds.
   */
  private static final int LANDING_SECONDS = 60;

  /**
   * Maximum time for an interrupted program to land its drones [s]. Decided: djitellopy waits 7 s
   * for a reply before it lands.
   */
  private static final int INTERRUPTED_SECONDS = 20;

  /** Maximum time for a program to end after the TERM signal [s]. Decided. */
  private static final int GRACE_SECONDS = 2;

  private final Plan plan;
  private final PrintStream out;
  private final AtomicBoolean interrupted = new AtomicBoolean();
  private volatile Optional<Process> simulator = Optional.empty();
  private volatile Optional<Process> program = Optional.empty();
  private volatile boolean inNamespace;
  private volatile boolean terminated;
  private volatile Optional<ExceededLimit> exceeded = Optional.empty();

  /**
   * The commands of a run.
   *
   * @param simulator the command that starts a simulator, without its listen addresses
   * @param program the command that starts the operator program
   * @param drones the number of drones, at most {@link #MOST_DRONES}
   * @param network how the program finds the drones
   * @param window whether the simulator has a window; the window stays open when the program has
   *     ended
   * @param output the file for the program's output; empty if it writes to the output of this
   *     program
   * @param distrust how far the program is trusted; empty if it may do whatever this program may
   */
  public record Plan(
      List<String> simulator,
      List<String> program,
      int drones,
      NetworkChoice network,
      boolean window,
      Optional<Path> output,
      Optional<Distrust> distrust) {

    public Plan {
      simulator = List.copyOf(simulator);
      program = List.copyOf(program);
    }
  }

  /** How a program finds the drones at the addresses of real ones. */
  public enum NetworkChoice {
    /** In a private network. */
    PRIVATE,
    /** By a shim in the program, in the network of this machine. */
    SHIM,
    /** In a private network, or with a shim if this system does not permit one. */
    EITHER
  }

  /**
   * How a program is run that is not trusted.
   *
   * @param confinement what the program may see and use; with {@link NetworkChoice#SHIM}, the
   *     program is started in {@link Confinement#files}, and only its limits apply
   * @param log the file for errors and warnings of the simulator
   */
  public record Distrust(Confinement confinement, Path log) {}

  /**
   * Exit code of a simulator that ended because the program does not wait for replies. Decided: one
   * that no other end has.
   */
  public static final int NOT_WAITING = 5;

  /** Maximum number of drones. */
  public static final int MOST_DRONES = OperatorNetwork.MOST_DRONES;

  /**
   * The exit codes of a run.
   *
   * @param program exit code of the operator program; empty if it did not end by itself
   * @param simulator exit code of the simulator
   */
  public record ExitCodes(OptionalInt program, int simulator) {}

  /**
   * Creates a run without starting it.
   *
   * @param out receives the output of the simulator
   */
  public ProgramRun(Plan plan, PrintStream out) {
    this.plan = plan;
    this.out = out;
  }

  /**
   * Runs both processes until both have ended.
   *
   * @return the exit codes; empty if the simulator did not start, in which case the simulator has
   *     reported the error
   * @throws UnavailableException if the plan requires a private network and this system does not
   *     permit one; the message is one sentence
   * @throws IOException if the program cannot be started; the message is a clause
   */
  public Optional<ExitCodes> run() throws UnavailableException, IOException, InterruptedException {
    try (ProgramNetwork network = network()) {
      inNamespace = network.ownsProcesses();
      Process flown = startSimulator(network);
      try (BufferedReader lines = flown.inputReader()) {
        Optional<String> ready = awaitReady(lines);
        if (ready.isEmpty()) {
          flown.waitFor();
          return Optional.empty();
        }
        try (Worker passing = Worker.start("simulator-output", new Passing(lines))) {
          ExitCodes codes = runProgram(network, network.variables(ready.get()), flown);
          passing.end();
          return Optional.of(codes);
        }
      }
    } finally {
      close();
    }
  }

  private ProgramNetwork network() throws UnavailableException, IOException, InterruptedException {
    if (plan.network() == NetworkChoice.SHIM) {
      return ShimNetwork.create(plan.drones());
    }
    try {
      return OperatorNetwork.create(plan.drones());
    } catch (UnavailableException e) {
      if (plan.network() == NetworkChoice.PRIVATE) {
        throw e;
      }
      out.println("The program finds the drones with a shim. " + e.getMessage());
      return ShimNetwork.create(plan.drones());
    }
  }

  private Process startSimulator(ProgramNetwork network) throws IOException {
    Redirect errors =
        plan.distrust().map(each -> Redirect.to(each.log().toFile())).orElse(Redirect.INHERIT);
    Process flown =
        new ProcessBuilder(network.simulator(plan.simulator())).redirectError(errors).start();
    simulator = Optional.of(flown);
    if (interrupted.get()) {
      flown.toHandle().destroy(); // its output can still be read
    }
    return flown;
  }

  private Optional<String> awaitReady(BufferedReader lines) throws IOException {
    for (String line = lines.readLine(); line != null; line = lines.readLine()) {
      out.println(line);
      if (line.startsWith(READY)) {
        return Optional.of(line);
      }
    }
    return Optional.empty();
  }

  private ExitCodes runProgram(ProgramNetwork network, Map<String, String> variables, Process flown)
      throws IOException, InterruptedException {
    ProcessBuilder builder = new ProcessBuilder(programCommand(network)).inheritIO();
    builder.environment().putAll(variables);
    plan.distrust().ifPresent(each -> each.confinement().prepare(builder, inNamespace));
    if (plan.output().isEmpty()) {
      return end(builder.start(), flown, Optional.empty());
    }
    int limit =
        plan.distrust()
            .map(each -> each.confinement().limits().outputBytes())
            .orElse(BoundedCopy.LIMIT);
    try (OutputStream file = Files.newOutputStream(plan.output().get())) {
      Process flying = builder.redirectErrorStream(true).redirectOutput(Redirect.PIPE).start();
      BoundedCopy copy = new BoundedCopy(flying.getInputStream(), file, limit);
      try (Worker writing = Worker.start("program-output", copy)) {
        ExitCodes codes = end(flying, flown, Optional.of(copy));
        writing.end();
        return codes;
      }
    }
  }

  private List<String> programCommand(ProgramNetwork network) {
    return network.program(plan.program(), plan.distrust().map(Distrust::confinement));
  }

  /** Waits until one of the processes has ended, and then ends the other one. */
  private ExitCodes end(Process flying, Process flown, Optional<BoundedCopy> copy)
      throws InterruptedException {
    program = Optional.of(flying);
    Optional<LimitWatch> watch =
        plan.distrust().map(each -> new LimitWatch(each.confinement().limits()));
    while (flown.isAlive()
        && exceeded.isEmpty()
        && !flying.waitFor(NOTICE_MS, TimeUnit.MILLISECONDS)) {
      long printed = copy.map(BoundedCopy::printed).orElse(0L);
      exceeded = watch.flatMap(each -> each.exceeded(flying, printed));
    }
    if (exceeded.isPresent() && exceeded.get() != ExceededLimit.TIME) {
      kill(flying); // it must not go on for two seconds
    } else if (flying.isAlive()) {
      terminate(flying);
    }
    int code = flying.waitFor();
    OptionalInt own = terminated ? OptionalInt.empty() : OptionalInt.of(code);
    out.println("program: " + (terminated ? "ended by run" : "exit code " + code));
    return new ExitCodes(own, finish(flown));
  }

  /**
   * Ends a simulator whose program has ended, or waits until the simulator's window is closed;
   * returns the simulator's exit code.
   */
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
      flown.destroy(); // the simulator no longer reads its input
    }
    return flown.waitFor(LANDING_SECONDS, TimeUnit.SECONDS);
  }

  /** Passes on the output of a simulator until the output ends. */
  private final class Passing implements Agent {

    private final BufferedReader lines;

    private Passing(BufferedReader lines) {
      this.lines = lines;
    }

    @Override
    public Outcome doWork() throws IOException {
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        out.println(line); // reads to the end, otherwise the last lines would be lost
      }
      return Outcome.FINISHED;
    }

    @Override
    public ErrorPolicy onError(Throwable failure) {
      return ErrorPolicy.finish("The simulator's output is no longer forwarded");
    }
  }

  /** Returns the limit because of which the program was killed; empty if there is none. */
  public Optional<ExceededLimit> exceeded() {
    return exceeded;
  }

  /** Whether {@link #interrupt} has been called. */
  boolean interrupted() {
    return interrupted.get();
  }

  /**
   * Interrupts the program as Ctrl-C does, and terminates it if it has not ended after 20 s. The
   * simulator keeps running meanwhile. A second call kills both processes immediately.
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
    if (WINDOWS) { // its console has interrupted the program already
      flying.waitFor(INTERRUPTED_SECONDS, TimeUnit.SECONDS);
      terminate(flying);
      return;
    }
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

  /** Ends both processes, whatever their state, even if the program ignores signals. */
  @Override
  public void close() {
    interrupted.set(true); // a simulator that is being started ends as well
    simulator.map(Process::toHandle).ifPresent(ProcessHandle::destroy);
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

  /** Returns the program and all its descendants. */
  private Stream<ProcessHandle> started(Process flying) {
    return inNamespace
        ? flying.children().flatMap(ProcessHandle::descendants)
        : Stream.concat(Stream.of(flying.toHandle()), flying.descendants());
  }

  /** Kills the first process of the namespace, and with it all others. */
  private void kill(Process flying) {
    terminated = true;
    List<ProcessHandle> first = (inNamespace ? flying.children() : flying.descendants()).toList();
    flying.destroyForcibly(); // otherwise unshare of util-linux 2.38 would print an error
    first.forEach(ProcessHandle::destroyForcibly);
  }

  /** Returns a command that consists of the words of two commands. */
  static List<String> joined(List<String> first, List<String> second) {
    return Stream.of(first, second).flatMap(List::stream).toList();
  }
}
