package tellosimulator.headless;

import java.io.BufferedReader;
import java.io.PrintStream;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import tellosimulator.concurrent.Worker;
import tellosimulator.control.ControlServer;
import tellosimulator.goal.Progress;
import tellosimulator.goal.Score;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.PortTakenException;
import tellosimulator.recording.FlightResult;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenario.ScenarioException;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.SoftwareCameras;
import tellosimulator.web.ScenarioHost;
import tellosimulator.web.WebServer;
import tellosimulator.web.WebSubject;

/**
 * The simulator without a window. It switches all drones on, prints a line when it is ready, and
 * reads commands from a console. Browsers can open other scenarios, each in a session of its own.
 */
public final class HeadlessSimulator implements AutoCloseable, ScenarioHost {

  /**
   * Maximum time for which a program may continue after the verdict [ms]. Decided: long enough to
   * switch its stream off and exit.
   */
  private static final long FAREWELL_MS = 5000;

  /**
   * The rules that apply to every scenario.
   *
   * @param applied applies the command-line options to a scenario
   * @param plan assigns the address at which each drone listens
   * @param replyPort the port to which all replies go; if empty, each reply goes to the port from
   *     which its command came
   * @param cameras creates a camera for each drone's video
   */
  public record Rules(
      UnaryOperator<Scenario> applied,
      Function<Scenario, AddressPlan> plan,
      OptionalInt replyPort,
      SoftwareCameras cameras) {}

  private final Rules rules;
  private volatile HeadlessSession session;
  private volatile WebSubject subject;
  private Optional<RecordingFolder> recordings = Optional.empty();
  private List<String> words = List.of();
  private boolean closed;
  private volatile Optional<ControlServer> control = Optional.empty();
  private volatile Optional<WebServer> web = Optional.empty();

  /**
   * Starts the simulation with all drones off.
   *
   * @param first the scenario, with all options applied
   */
  public HeadlessSimulator(OpenedScenario first, Rules rules) {
    this.rules = rules;
    session = session(first, rules.plan.apply(first.scenario()));
  }

  private HeadlessSession session(OpenedScenario opened, AddressPlan plan) {
    return new HeadlessSession(opened, plan, rules.replyPort, rules.cameras);
  }

  /**
   * Opens the sockets and switches all drones on.
   *
   * @throws PortTakenException if an address or port cannot be opened
   */
  public void switchOn() throws PortTakenException {
    session.simulation.switchAllOn();
  }

  /**
   * Opens the control channel and prints its address. Must be called after {@link #switchOn} and
   * before {@link #sayReady}.
   *
   * @param port the port; 0 lets the system choose
   * @throws PortTakenException if the port cannot be opened
   */
  public void openControl(int port, PrintStream out) throws PortTakenException {
    current(); // listens from now on
    ControlServer server = new ControlServer(() -> current().requests(), port);
    control = Optional.of(server);
    out.println(server.line());
  }

  /**
   * Opens the page for browsers and prints its link. Must be called before {@link #switchOn}, so
   * that its log is complete.
   *
   * @param address the address; port 0 lets the system choose
   * @throws PortTakenException if the port cannot be opened
   */
  public void openWeb(InetSocketAddress address, PrintStream out) throws PortTakenException {
    current(); // listens from now on
    WebServer server = WebServer.of(this, address);
    web = Optional.of(server);
    server.lines().forEach(out::println);
  }

  @Override
  public WebSubject current() {
    WebSubject known = subject;
    return known == null ? firstSubject() : known;
  }

  private synchronized WebSubject firstSubject() {
    if (subject == null) {
      subject = session.subject(1, rules.cameras);
    }
    return subject;
  }

  @Override
  public Optional<RecordingFolder> recordings() {
    return recordings;
  }

  @Override
  public synchronized void open(OpenedScenario chosen, OptionalLong seed)
      throws ScenarioException, PortTakenException {
    OpenedScenario next = chosen.under(rules.applied, seed);
    AddressPlan plan = rules.plan.apply(next.scenario());
    if (closed) {
      return;
    }
    HeadlessSession before = session;
    before.close();
    session = session(next, plan);
    recordings.ifPresent(folder -> session.record(folder, words));
    subject = session.subject(current().number() + 1, rules.cameras);
    before.exitCondition.now(); // whoever waits for its end waits for the new one
    session.simulation.switchAllOn();
  }

  /**
   * Starts to record all flights. Must be called before {@link #switchOn}; otherwise the flights
   * cannot be replayed.
   *
   * @param options the command-line arguments
   */
  public void record(RecordingFolder folder, List<String> options) {
    recordings = Optional.of(folder);
    words = List.copyOf(options);
    session.record(folder, options);
  }

  /** Prints the ready line with the addresses of the drones. */
  public void sayReady(PrintStream out) {
    shrinkHeap();
    out.println(session.simulation.ready());
    out.flush();
  }

  /**
   * Reads the console. Returns after {@code quit}, or after {@code finish} once the drones have
   * landed. Does not return if the input ends without either.
   */
  public void run(BufferedReader in, PrintStream out) throws InterruptedException {
    startConsole(in, out);
    HeadlessSession waited;
    do {
      waited = session;
      waited.exitCondition.awaitFinish();
    } while (waited != session); // a browser has opened another scenario
    waited.exitCondition.awaitResult(waited.standstill);
    waited.exitCondition.awaitRest(waited.standstill);
  }

  /**
   * Reads the console. Returns after {@code quit}, or when the goals have been reached or missed
   * and the drones have landed. {@code finish} lands all drones.
   *
   * <p>The goals also count as missed if all drones have landed and no command has arrived for 15
   * s. The same is true if a program has sent a command, but no drone has taken off and no further
   * command has arrived for a minute. At time factor {@code max}, simulated time would stand still
   * during these periods. It is therefore advanced by the whole period when no command has arrived
   * for a while in wall clock time.
   *
   * @param timeout the time after which the goals count as missed in any case [simulated s]; empty
   *     for none
   * @param programRuns whether a program is running, at whose end {@code finish} will be typed. If
   *     so, the program may continue for up to 5 s after the verdict, and the goals also count as
   *     missed if it has sent no command after two minutes
   * @return the status of the goals, which is still {@code RUNNING} after {@code quit}
   */
  public Progress.Status runUntilDone(
      Optional<Double> timeout, boolean programRuns, BufferedReader in, PrintStream out)
      throws InterruptedException {
    ExitCondition exitCondition = session.exitCondition;
    exitCondition.limit(timeout, programRuns);
    startConsole(in, out);
    Progress result = exitCondition.awaitResult(session.standstill);
    out.println(result.phrase());
    out.flush();
    if (programRuns && !session.pace.impatient()) {
      exitCondition.awaitFinish(FAREWELL_MS);
      landAll();
    }
    exitCondition.awaitRest(session.standstill);
    return result.status();
  }

  /**
   * Ends the run as soon as the program sends a command without waiting for the reply to the one
   * before, so that its flight depends on when simulated time passes.
   */
  public void endUnlessProgramWaits() {
    session.pace.activate();
  }

  /** Whether the run has ended because the program did not wait for a reply. */
  public boolean programDidNotWait() {
    return session.pace.impatient();
  }

  private void landAll() {
    for (SimSnapshot.DroneSnapshot drone : snapshot().drones()) {
      try {
        carryOut(new Control.Land(drone.state().drone()));
      } catch (PortTakenException e) {
        throw new IllegalStateException("a landing opens no port", e);
      }
    }
  }

  private void carryOut(Control control) throws PortTakenException {
    session.simulation.carryOut(control);
  }

  private void startConsole(BufferedReader in, PrintStream out) {
    Worker.start(
        "console",
        new Console(this::snapshot, this::carryOut, in, out)
            .agent(() -> session.exitCondition.finish(), () -> session.exitCondition.now()));
  }

  /** Returns the final score; empty without points. Must be called after {@link #close}. */
  public Optional<Score> score() {
    return session.goals.progress().score();
  }

  /** Returns the outcome of the present scenario. Must be called after {@link #close}. */
  public FlightResult result() {
    return session.result();
  }

  /** Returns the latest snapshot. Thread-safe. */
  SimSnapshot snapshot() {
    return session.simulation.snapshot();
  }

  /**
   * Returns memory to the system. The JVM starts with a heap of one sixty-fourth of the machine's
   * memory, and fills it before the second collection. A full collection shrinks the heap to the
   * few megabytes that a simulation needs. Measured: at "ready", the resident memory is 61 MB
   * instead of 76 MB (medians of 24 alternating runs).
   */
  private static void shrinkHeap() {
    System.gc();
  }

  @Override
  public synchronized void close() {
    closed = true;
    web.ifPresent(WebServer::close);
    control.ifPresent(ControlServer::close);
    session.close();
  }
}
