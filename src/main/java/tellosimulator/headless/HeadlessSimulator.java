package tellosimulator.headless;

import java.io.BufferedReader;
import java.io.PrintStream;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import tellosimulator.concurrent.Worker;
import tellosimulator.control.ControlServer;
import tellosimulator.goal.GoalWatch;
import tellosimulator.goal.Progress;
import tellosimulator.junit.TelloSimulator;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.network.PortTakenException;
import tellosimulator.recording.FlightRecorder;
import tellosimulator.recording.FlightRecorder.Subject;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.LogLimiter;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.SoftwareCameras;
import tellosimulator.video.VideoStreams;
import tellosimulator.video.codec.H264Encoder;

/** The program without a window: drones that are on, a console, and a line when it is ready. */
public final class HeadlessSimulator implements AutoCloseable {

  /**
   * How long a program may go on after the verdict [ms]. Decided: it switches its stream off and
   * says goodbye.
   */
  private static final long FAREWELL_MS = 5000;

  private final Scenario scenario;
  private final GoalWatch goals;
  private final ExitCondition exitCondition;
  private final ExitCondition.Standstill standstill = new AsFastAsPossible();
  private final OnlineSimulation simulation;
  private final VideoStreams video;
  private volatile Optional<ControlServer> control = Optional.empty();
  private volatile Optional<FlightRecorder> recorder = Optional.empty();

  /**
   * Starts the simulation; all drones are off.
   *
   * @param replyPort port to which all replies go; empty for the port each command came from
   * @param cameras makes a camera for each drone's video
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
    exitCondition = new ExitCondition(goals);
    simulation =
        new OnlineSimulation(
            scenario.config(), plan, replyPort, List.of(new LogLimiter(log), goals, exitCondition));
    video = VideoStreams.of(simulation, cameras, H264Encoder::new);
  }

  /**
   * Opens the sockets and switches all drones on.
   *
   * @throws PortTakenException if an address or port cannot be had
   */
  public void switchOn() throws PortTakenException {
    simulation.switchAllOn();
  }

  /**
   * Opens the control channel, and says where it is. After {@link #switchOn} and before {@link
   * #sayReady}.
   *
   * @param port 0 for one that the system chooses
   * @throws PortTakenException if the port cannot be had
   */
  public void openControl(int port, PrintStream out) throws PortTakenException {
    ControlServer server = new ControlServer(TelloSimulator.of(simulation, scenario, goals), port);
    control = Optional.of(server);
    out.println(server.line());
  }

  /**
   * Records all flights from now on. Before {@link #switchOn}, or else they cannot be flown again.
   *
   * @param title of the scenario, or the name of its file
   * @param options words of the command line
   */
  public void record(RecordingFolder folder, String title, List<String> options) {
    Subject subject = new Subject(title, scenario, options, goals);
    FlightRecorder started = FlightRecorder.start(folder, subject, reason -> {});
    started.attach(simulation, video);
    recorder = Optional.of(started);
  }

  /** Says that it is ready, and where the drones are. */
  public void sayReady(PrintStream out) {
    shrinkHeap();
    out.println(simulation.ready());
    out.flush();
  }

  /**
   * Takes what is typed; returns after {@code quit}, or after {@code finish} when the drones are
   * down, and never if the input ends without either.
   */
  public void run(BufferedReader in, PrintStream out) throws InterruptedException {
    startConsole(in, out);
    exitCondition.awaitFinish();
    exitCondition.awaitResult(standstill);
    exitCondition.awaitRest(standstill);
  }

  /**
   * Takes what is typed, and returns after {@code quit}, or when the goals are reached or missed
   * and the drones have come down, as they do on {@code finish}. They are missed, too, when all
   * drones have landed and are silent for 15 s, or a program has spoken, let none take off, and is
   * silent for a minute; with time factor {@code max} these pass by themselves when no command has
   * come for a while of the wall clock.
   *
   * @param timeout after which the goals are missed in any case [simulated s]
   * @return whether the goals were reached; it still runs after {@code quit}
   */
  public Progress.Status runUntilDone(Optional<Double> timeout, BufferedReader in, PrintStream out)
      throws InterruptedException {
    exitCondition.limit(timeout);
    startConsole(in, out);
    Progress result = exitCondition.awaitResult(standstill);
    out.println(result.phrase());
    out.flush();
    exitCondition.awaitRest(standstill);
    return result.status();
  }

  /** Lets a program go on after the verdict, until {@code finish} is typed or time is over. */
  public void awaitFinish() throws InterruptedException {
    exitCondition.awaitFinish(FAREWELL_MS);
  }

  /** Time stands still only as fast as possible. */
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

  /** A recent state of everything; for any thread. */
  SimSnapshot snapshot() {
    return simulation.snapshot();
  }

  /**
   * Gives memory back. The JVM starts with a sixty-fourth of the machine's memory as heap and fills
   * it before it collects for the second time; a full collection lets it adopt the few megabytes
   * that a simulation needs. Measured at "ready", in turns, medians of 24: 61 rather than 76 MB of
   * resident memory.
   */
  private static void shrinkHeap() {
    System.gc();
  }

  @Override
  public void close() {
    control.ifPresent(ControlServer::close);
    video.close();
    simulation.close();
    recorder.ifPresent(FlightRecorder::close);
  }
}
