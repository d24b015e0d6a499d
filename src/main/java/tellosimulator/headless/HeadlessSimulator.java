package tellosimulator.headless;

import java.io.BufferedReader;
import java.io.PrintStream;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.slf4j.event.Level;
import tellosimulator.concurrent.Worker;
import tellosimulator.control.ControlServer;
import tellosimulator.goal.GoalWatch;
import tellosimulator.goal.Progress;
import tellosimulator.goal.Score;
import tellosimulator.junit.TelloSimulator;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.network.PortTakenException;
import tellosimulator.recording.FlightRecorder;
import tellosimulator.recording.FlightRecorder.Subject;
import tellosimulator.recording.FlightResult;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.Control;
import tellosimulator.sim.LogLimiter;
import tellosimulator.sim.Severity;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.SoftwareCameras;
import tellosimulator.video.VideoStreams;
import tellosimulator.video.codec.H264Encoder;

/**
 * The simulator without a window. It switches all drones on, prints a line when it is ready, and
 * reads commands from a console.
 */
public final class HeadlessSimulator implements AutoCloseable {

  /**
   * Maximum time for which a program may continue after the verdict [ms]. Decided: long enough to
   * switch its stream off and exit.
   */
  private static final long FAREWELL_MS = 5000;

  private final Scenario scenario;
  private final GoalWatch goals;
  private final ExitCondition exitCondition;
  private final ExitCondition.Standstill standstill = new AsFastAsPossible();
  private final PaceWatch pace;
  private final OnlineSimulation simulation;
  private final VideoStreams video;
  private volatile Optional<ControlServer> control = Optional.empty();
  private volatile Optional<FlightRecorder> recorder = Optional.empty();

  /**
   * Starts the simulation with all drones off.
   *
   * @param replyPort the port to which all replies go; if empty, each reply goes to the port from
   *     which its command came
   * @param cameras creates a camera for each drone's video
   */
  public HeadlessSimulator(
      Scenario scenario, AddressPlan plan, OptionalInt replyPort, SoftwareCameras cameras) {
    this.scenario = scenario;
    EventLog log = new EventLog();
    goals =
        new GoalWatch(
            scenario.challenge(),
            news -> {
              log.event(news);
              recorder.ifPresent(each -> each.event(news));
            });
    exitCondition = new ExitCondition(goals, this::endAttempt);
    pace = new PaceWatch(exitCondition::now);
    List<SimListener> listeners = List.of(new LogLimiter(log), goals, exitCondition, pace);
    simulation = new OnlineSimulation(scenario.config(), plan, replyPort, listeners);
    video = VideoStreams.of(simulation, cameras, H264Encoder::new);
  }

  /** Makes the end of the attempt part of the flight: a replay reaches no goal after it either. */
  private void endAttempt() {
    if (!scenario.challenge().goals().isEmpty()) {
      simulation.endAttempt();
    }
  }

  /**
   * Opens the sockets and switches all drones on.
   *
   * @throws PortTakenException if an address or port cannot be opened
   */
  public void switchOn() throws PortTakenException {
    simulation.switchAllOn();
  }

  /**
   * Opens the control channel and prints its address. Must be called after {@link #switchOn} and
   * before {@link #sayReady}.
   *
   * @param port the port; 0 lets the system choose
   * @throws PortTakenException if the port cannot be opened
   */
  public void openControl(int port, PrintStream out) throws PortTakenException {
    ControlServer server = new ControlServer(TelloSimulator.of(simulation, scenario, goals), port);
    control = Optional.of(server);
    out.println(server.line());
  }

  /**
   * Starts to record all flights. Must be called before {@link #switchOn}; otherwise the flights
   * cannot be replayed.
   *
   * @param title the title of the scenario, or the name of its file
   * @param options the command-line arguments
   */
  public void record(RecordingFolder folder, String title, List<String> options) {
    Subject subject = new Subject(title, scenario, options, goals);
    FlightRecorder started = FlightRecorder.start(folder, subject, reason -> {});
    started.attach(simulation, video);
    recorder = Optional.of(started);
  }

  /** Prints the ready line with the addresses of the drones. */
  public void sayReady(PrintStream out) {
    shrinkHeap();
    out.println(simulation.ready());
    out.flush();
  }

  /**
   * Reads the console. Returns after {@code quit}, or after {@code finish} once the drones have
   * landed. Does not return if the input ends without either.
   */
  public void run(BufferedReader in, PrintStream out) throws InterruptedException {
    startConsole(in, out);
    exitCondition.awaitFinish();
    exitCondition.awaitResult(standstill);
    exitCondition.awaitRest(standstill);
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
    exitCondition.limit(timeout, programRuns);
    startConsole(in, out);
    Progress result = exitCondition.awaitResult(standstill);
    out.println(result.phrase());
    out.flush();
    if (programRuns && !pace.impatient()) {
      exitCondition.awaitFinish(FAREWELL_MS);
      landAll();
    }
    exitCondition.awaitRest(standstill);
    return result.status();
  }

  /**
   * Ends the run as soon as the program sends a command without waiting for the reply to the one
   * before, so that its flight depends on when simulated time passes.
   */
  public void endUnlessProgramWaits() {
    pace.activate();
  }

  /** Whether the run has ended because the program did not wait for a reply. */
  public boolean programDidNotWait() {
    return pace.impatient();
  }

  private void landAll() {
    for (SimSnapshot.DroneSnapshot drone : snapshot().drones()) {
      try {
        simulation.carryOut(new Control.Land(drone.state().drone()));
      } catch (PortTakenException e) {
        throw new IllegalStateException("a landing opens no port", e);
      }
    }
  }

  /**
   * Advances simulated time when it stands still, which happens only at time factor {@code max}.
   */
  private final class AsFastAsPossible implements ExitCondition.Standstill {

    @Override
    public boolean possible() {
      SimSnapshot.Clock clock = snapshot().clock();
      return clock.factor().unlimited() && !clock.paused();
    }

    @Override
    public void pass(double seconds) {
      simulation.letPass(seconds);
    }
  }

  private void startConsole(BufferedReader in, PrintStream out) {
    Worker.start(
        "console",
        new Console(simulation::snapshot, simulation::carryOut, in, out)
            .agent(exitCondition::finish, exitCondition::now));
  }

  /** Returns the final score; empty without points. Must be called after {@link #close}. */
  public Optional<Score> score() {
    return goals.progress().score();
  }

  /** Returns the outcome of the run. Must be called after {@link #close}. */
  public FlightResult result() {
    Progress last = goals.progress();
    boolean goalless = scenario.challenge().goals().isEmpty(); // nothing can be missed
    Progress verdict = goalless ? last : exitCondition.verdict().orElse(last);
    boolean missed = !goalless && exitCondition.missed();
    return FlightResult.of(verdict, missed, last.score(), goals.tally());
  }

  /** Returns the latest snapshot. Thread-safe. */
  SimSnapshot snapshot() {
    return simulation.snapshot();
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
  public void close() {
    control.ifPresent(ControlServer::close);
    video.close();
    simulation.close();
    goals.close();
    recorder.ifPresent(FlightRecorder::close);
  }

  /** Writes events to the log, at the level that corresponds to their {@link Severity}. */
  private static final class EventLog implements SimListener {

    private static final Logger LOG = LoggerFactory.getLogger("tellosimulator.event");

    @Override
    public void event(SimEvent event) {
      LOG.atLevel(level(event.severity())).log("{}", lineOf(event));
    }

    private static Level level(Severity severity) {
      return switch (severity) {
        case ERROR -> Level.ERROR;
        case WARNING -> Level.WARN;
        case INFORMATION -> Level.INFO;
        case DETAIL -> Level.DEBUG;
      };
    }

    /** Returns an object that formats the line only when it is written. */
    private static Object lineOf(SimEvent event) {
      return new Object() {
        @Override
        public String toString() {
          return event.line();
        }
      };
    }
  }
}
