package tellosimulator.headless;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.slf4j.event.Level;
import tellosimulator.control.Requests;
import tellosimulator.goal.GoalWatch;
import tellosimulator.goal.Progress;
import tellosimulator.junit.TelloSimulator;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.recording.FlightRecorder;
import tellosimulator.recording.FlightRecorder.Subject;
import tellosimulator.recording.FlightResult;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.LogLimiter;
import tellosimulator.sim.Severity;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.SoftwareCameras;
import tellosimulator.video.VideoStreams;
import tellosimulator.video.codec.H264Encoder;
import tellosimulator.web.WebSubject;

/** A scenario that is being flown without a window, with its simulation and its drones' video. */
final class HeadlessSession implements AutoCloseable {

  final ExitCondition exitCondition;
  final ExitCondition.Standstill standstill = new AsFastAsPossible();
  final PaceWatch pace;
  final GoalWatch goals;
  final OnlineSimulation simulation;
  private final OpenedScenario opened;
  private final VideoStreams video;
  private volatile Optional<FlightRecorder> recorder = Optional.empty();

  /** Starts the simulation with all drones off. */
  HeadlessSession(
      OpenedScenario opened, AddressPlan plan, OptionalInt replyPort, SoftwareCameras cameras) {
    this.opened = opened;
    EventLog log = new EventLog();
    goals =
        new GoalWatch(
            scenario().challenge(),
            news -> {
              log.event(news);
              recorder.ifPresent(each -> each.event(news));
            });
    exitCondition = new ExitCondition(goals, this::endAttempt);
    pace = new PaceWatch(exitCondition::now);
    List<SimListener> listeners = List.of(new LogLimiter(log), goals, exitCondition, pace);
    simulation = new OnlineSimulation(scenario().config(), plan, replyPort, listeners);
    video = VideoStreams.of(simulation, cameras, H264Encoder::new);
  }

  private Scenario scenario() {
    return opened.scenario();
  }

  /** Makes the end of the attempt part of the flight: a replay reaches no goal after it either. */
  private void endAttempt() {
    if (!scenario().challenge().goals().isEmpty()) {
      simulation.endAttempt();
    }
  }

  /** Starts to record all flights. Must be called before any drone is switched on. */
  void record(RecordingFolder folder, List<String> options) {
    Subject subject = new Subject(opened.title(), scenario(), options, goals);
    FlightRecorder started = FlightRecorder.start(folder, subject, reason -> {});
    started.attach(simulation, video);
    recorder = Optional.of(started);
  }

  /** Returns what programs in other languages can ask of this session. */
  Requests requests() {
    return new Requests(TelloSimulator.of(simulation, scenario(), goals));
  }

  /**
   * Returns what a browser shows of this session.
   *
   * @param number the number of the session, from 1
   */
  WebSubject subject(int number, SoftwareCameras cameras) {
    return WebSubject.of(number, opened, simulation, goals, video, cameras.scenes(), requests());
  }

  /** Returns the outcome. Must be called after {@link #close}. */
  FlightResult result() {
    Progress last = goals.progress();
    boolean goalless = scenario().challenge().goals().isEmpty(); // nothing can be missed
    Progress verdict = goalless ? last : exitCondition.verdict().orElse(last);
    boolean missed = !goalless && exitCondition.missed();
    return FlightResult.of(verdict, missed, last.score(), goals.tally());
  }

  @Override
  public void close() {
    video.close();
    simulation.close();
    goals.close();
    recorder.ifPresent(FlightRecorder::close);
  }

  /**
   * Advances simulated time when it stands still, which happens only at time factor {@code max}.
   */
  private final class AsFastAsPossible implements ExitCondition.Standstill {

    @Override
    public boolean possible() {
      SimSnapshot.Clock clock = simulation.snapshot().clock();
      return clock.factor().unlimited() && !clock.paused();
    }

    @Override
    public void pass(double seconds) {
      simulation.letPass(seconds);
    }
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
