package tellosimulator.view.app;

import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import javafx.application.Platform;
import javafx.stage.Stage;
import javafx.util.Subscription;
import tellosimulator.control.Requests;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.GoalEvent;
import tellosimulator.goal.GoalWatch;
import tellosimulator.goal.Progress;
import tellosimulator.junit.TelloSimulator;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.recording.FlightRecorder;
import tellosimulator.recording.FlightRecorder.Subject;
import tellosimulator.recording.FlightResult;
import tellosimulator.scenario.EditedScenario;
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenario.ScenarioDocument;
import tellosimulator.scenario.ScenarioFile;
import tellosimulator.sim.LogLimiter;
import tellosimulator.video.SoftwareCameras;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.layout.WindowState;
import tellosimulator.view.layout.WindowState.Flag;
import tellosimulator.view.log.LogLevel;
import tellosimulator.view.log.LogQueue;
import tellosimulator.view.model.FxScenario;
import tellosimulator.view.model.ScenarioActions;
import tellosimulator.view.model.UiTicker;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.settings.Settings;
import tellosimulator.view.text.Language;
import tellosimulator.view.video.MediaFolder;
import tellosimulator.view.video.WindowVideo;
import tellosimulator.web.WebSubject;

/**
 * A scenario that is being flown, with its simulation, its drones' video, and the content of the
 * window. A new scenario gets a new session in the same stage.
 */
final class ScenarioSession implements AutoCloseable {

  /**
   * The number of frames between checks for unsaved changes. Decided: a quarter of a second at 60
   * frames a second.
   */
  private static final int FRAMES_BETWEEN_LOOKS = 15;

  /**
   * The settings for the communication between drones and operators.
   *
   * @param plan the addresses at which the drones listen
   * @param replyPort the port to which all replies go; if empty, each reply goes to the port from
   *     which its command came
   * @param recordings the settings for recording flights
   */
  record Wire(AddressPlan plan, OptionalInt replyPort, SimulatorApp.Recordings recordings) {}

  /** The parts that remain when the scenario changes. */
  record Frame(Stage stage, Language language, WindowState state, Settings settings) {}

  private volatile EditedScenario edited;
  private final DroneOptics optics;
  private final LogQueue logQueue;
  private final GoalWatch goals;
  private final OnlineSimulation simulation;
  private final WindowVideo video;
  private final SimulatorApp.Recordings recordings;
  private final FlightRecorder recorder;
  private Subscription recording = Subscription.EMPTY;
  private SimulatorWindow window;
  private ViewContext context;
  private Frame frame;
  private int frames;

  /** Starts the simulation with all drones off. */
  ScenarioSession(EditedScenario edited, Wire wire, DroneOptics optics, LogQueue logQueue) {
    this.edited = edited;
    this.optics = optics;
    this.logQueue = logQueue;
    Scenario scenario = edited.present();
    recordings = wire.recordings();
    goals = new GoalWatch(scenario.challenge(), this::tell);
    recorder =
        FlightRecorder.start(
            recordings.folder(),
            new Subject(edited.opened().title(), scenario, recordings.options(), goals),
            reason -> logQueue.say(LogLevel.WARN, language -> language.say(reason)));
    simulation =
        new OnlineSimulation(
            scenario.config(),
            wire.plan(),
            wire.replyPort(),
            List.of(new LogLimiter(logQueue), goals));
    video = WindowVideo.of(simulation, optics, MediaFolder.ofUser());
    recorder.attach(simulation, video.streams());
  }

  private void tell(GoalEvent news) {
    logQueue.event(news);
    recorder.event(news);
  }

  OnlineSimulation simulation() {
    return simulation;
  }

  /** Returns this session as the teacher's board sees it; see {@link WebSubject}. */
  WebSubject webSubject(int number) {
    return WebSubject.of(
        number,
        opened(),
        simulation,
        goals,
        video.streams(),
        new SoftwareCameras(optics).scenes(),
        new Requests(TelloSimulator.of(simulation, edited.present(), goals)));
  }

  OpenedScenario opened() {
    return edited.opened();
  }

  private void ask(Challenge challenge) {
    goals.ask(challenge);
    recorder.ask(challenge);
  }

  /**
   * Shows the session in a stage. This method and all methods below, except {@link #close}, are
   * confined to the JavaFX thread.
   */
  void showIn(Frame newFrame, ScenarioActions actions) {
    frame = newFrame;
    FxScenario scenario = new FxScenario(edited, goals, this::ask, actions);
    context = ViewContext.of(simulation, frame.language.linked(), video, scenario);
    context.ticker().onTick(nanos -> lookForEdits(scenario));
    window = new SimulatorWindow(frame.stage, context, frame.state.linked(), logQueue);
    window.remember(frame.settings);
    recording =
        frame
            .state
            .flag(Flag.RECORDED_FLIGHTS)
            .subscribe(wanted -> recorder.setRecording(wanted || recordings.always()));
    window.show();
  }

  /** Returns the content of the window. */
  SimulatorWindow window() {
    return window;
  }

  /**
   * Checks for unsaved changes every {@link #FRAMES_BETWEEN_LOOKS} frames rather than in each
   * frame, because the check compares the whole scenario.
   */
  private void lookForEdits(FxScenario scenario) {
    frames++;
    if (frames % FRAMES_BETWEEN_LOOKS == 0) {
      scenario.setUnsaved(unsaved());
    }
  }

  /** Runs an action whenever all goals have been reached. */
  void onSolved(Runnable action) {
    context
        .scenario()
        .progressProperty()
        .map(Progress::status)
        .subscribe(
            status -> {
              if (status == Progress.Status.REACHED) {
                action.run();
              }
            });
  }

  UiTicker ticker() {
    return context.ticker();
  }

  /** Returns whether any drone is switched on. */
  boolean on() {
    return context.simulation().drones().stream().anyMatch(drone -> drone.onProperty().get());
  }

  /** Switches all drones on; the log lists the drones that stay off, with the reasons. */
  void switchOn() {
    context
        .simulation()
        .drones()
        .forEach(drone -> context.actions().switchPower(drone.number(), true));
  }

  /** Returns the scenario in its current state. */
  EditedScenario present() {
    return edited.in(simulation.snapshot(), context.scenario().challenge());
  }

  /**
   * Returns the scenario for a new run. If the scenario comes from a file or the gallery, it is
   * returned as it was opened; otherwise, it is returned as it is now.
   */
  OpenedScenario asItBegins() {
    boolean plain = opened().file().isEmpty() && opened().known().isEmpty();
    return plain ? OpenedScenario.once(present().present()) : opened();
  }

  /** Returns a document that contains the current scenario, to be written to the given file. */
  ScenarioDocument toSave(Path file) {
    return opened().document().changedTo(present().toSave(), ScenarioFile.folder(file));
  }

  /** Runs a callback once the simulation has carried out all pending actions of the window. */
  void whenSettled(Runnable action) {
    if (context.actions().pending()) {
      context.actions().afterPending(() -> Platform.runLater(() -> whenSettled(action)));
    } else {
      action.run();
    }
  }

  /** Returns whether there are changes that have not been saved to a file. */
  boolean unsaved() {
    return present().unsaved();
  }

  /**
   * Registers the file to which the scenario has been written. From then on, reloading reads this
   * file.
   */
  void savedAs(ScenarioDocument document, Path file) {
    edited = present().savedAs(document, file);
    context.scenario().savedAs(file);
    context.scenario().setUnsaved(unsaved());
  }

  /** Releases the part of the session that belongs to the window. The stage stays open. */
  void leave() {
    recording.unsubscribe();
    window.close();
  }

  /** Stops the simulation, the video and the recording. Thread-safe. */
  @Override
  public void close() {
    video.close();
    simulation.close();
    goals.close();
    recorder.close();
  }

  /** Returns the outcome. Must be called after {@link #close}. */
  FlightResult result() {
    Progress last = goals.progress();
    return FlightResult.of(last, false, last.score(), goals.tally());
  }
}
