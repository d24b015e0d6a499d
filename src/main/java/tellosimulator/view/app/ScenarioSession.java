package tellosimulator.view.app;

import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import java.util.function.Function;
import javafx.application.Platform;
import javafx.stage.Stage;
import javafx.util.Subscription;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.GoalEvent;
import tellosimulator.goal.GoalWatch;
import tellosimulator.goal.Progress;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.recording.FlightRecorder;
import tellosimulator.recording.FlightRecorder.Subject;
import tellosimulator.scenario.EditedScenario;
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenario.ScenarioDocument;
import tellosimulator.scenario.ScenarioFile;
import tellosimulator.sim.LogLimiter;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.gallery.GalleryPane;
import tellosimulator.view.layout.QuestionPage.Question;
import tellosimulator.view.layout.WindowState;
import tellosimulator.view.log.LogLevel;
import tellosimulator.view.log.LogQueue;
import tellosimulator.view.log.ReportOffer;
import tellosimulator.view.model.FxScenario;
import tellosimulator.view.model.Pulse;
import tellosimulator.view.model.ScenarioActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.plan.PlanEditorState;
import tellosimulator.view.settings.Settings;
import tellosimulator.view.text.Language;
import tellosimulator.view.video.MediaFolder;
import tellosimulator.view.video.WindowVideo;

/**
 * A scenario while it is flown: its simulation, its drones' video, and what the window shows of
 * them. Another scenario has all of it anew, in the same stage.
 */
final class ScenarioSession implements AutoCloseable {

  /** Frames from look to look whether something is unsaved. Decided: a quarter of a second. */
  private static final int FRAMES_BETWEEN_LOOKS = 15;

  /**
   * How drones and operators reach each other.
   *
   * @param replyPort port to which all replies go; empty for the port each command came from
   * @param recordings where it is recorded what they say to each other
   */
  record Wire(AddressPlan plan, OptionalInt replyPort, SimulatorApp.Recordings recordings) {}

  /** What stays when the scenario changes. */
  record Frame(Stage stage, Language language, WindowState state, Settings settings) {}

  private EditedScenario edited;
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

  /** Starts its simulation; all drones are off. */
  ScenarioSession(EditedScenario edited, Wire wire, DroneOptics optics, LogQueue logQueue) {
    this.edited = edited;
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

  OpenedScenario opened() {
    return edited.opened();
  }

  private void ask(Challenge challenge) {
    goals.ask(challenge);
    recorder.ask(challenge);
  }

  /** Shows it in a stage. For the JavaFX thread, as all that follows but for {@link #close}. */
  void showIn(Frame newFrame, ScenarioActions actions) {
    frame = newFrame;
    FxScenario scenario = new FxScenario(edited, goals, this::ask, actions);
    context = ViewContext.of(simulation, frame.language.linked(), video, scenario);
    context.pulse().onBeat(nanos -> lookForEdits(scenario));
    window = new SimulatorWindow(frame.stage, context, frame.state.linked(), logQueue);
    window.remember(frame.settings);
    recording =
        frame
            .state
            .flightsRecordedProperty()
            .subscribe(wanted -> recorder.setRecording(wanted || recordings.always()));
    window.show();
  }

  /** Lets one open the report of the last flight. */
  void offer(ReportOffer report) {
    window.offer(report);
  }

  /** Not at each frame: it compares the whole scenario. */
  private void lookForEdits(FxScenario scenario) {
    frames++;
    if (frames % FRAMES_BETWEEN_LOOKS == 0) {
      scenario.setUnsaved(unsaved());
    }
  }

  /** Runs something whenever all goals have been reached. */
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

  Pulse pulse() {
    return context.pulse();
  }

  /** Whether any drone has power. */
  boolean on() {
    return context.simulation().drones().stream().anyMatch(drone -> drone.onProperty().get());
  }

  /** Switches all drones on; the log says which stay off, and why. */
  void switchOn() {
    context
        .simulation()
        .drones()
        .forEach(drone -> context.actions().switchPower(drone.number(), true));
  }

  /** Says in the window what is wrong with another scenario. */
  void show(List<Function<Language, String>> diagnostics) {
    window.show(diagnostics);
  }

  /** Lets somebody choose what to fly in, or closes that page. */
  void toggleGallery(GalleryPane.Offer offer) {
    window.toggleGallery(offer);
  }

  /** The scenario as it is now. */
  EditedScenario present() {
    return edited.in(simulation.snapshot(), context.scenario().challenge());
  }

  /** What to begin anew: as it was opened, or the room as it is now if that came from nowhere. */
  OpenedScenario asItBegins() {
    boolean plain = opened().file().isEmpty() && opened().known().isEmpty();
    return plain ? OpenedScenario.once(present().present()) : opened();
  }

  /** The document of what is there now, as it would be in a file. */
  ScenarioDocument toSave(Path file) {
    return opened().document().changedTo(present().toSave(), ScenarioFile.folder(file));
  }

  /** Does something when all that was done in the window has been carried out. */
  void whenSettled(Runnable action) {
    if (context.actions().pending()) {
      context.actions().afterPending(() -> Platform.runLater(() -> whenSettled(action)));
    } else {
      action.run();
    }
  }

  /** Whether there is something that no file has. */
  boolean unsaved() {
    return present().unsaved();
  }

  /** It has been written to a file, which from now on is the one to open again. */
  void savedAs(ScenarioDocument document, Path file) {
    edited = present().savedAs(document, file);
    context.scenario().savedAs(file);
    context.scenario().setUnsaved(unsaved());
  }

  /** What was planned, for the session that goes on with it. */
  PlanEditorState planned() {
    return window.planned();
  }

  /** Goes on with what was planned in another session. */
  void goOn(PlanEditorState planned) {
    window.goOn(planned);
  }

  /** Saves it to its file, or lets somebody choose one. */
  void save() {
    window.save();
  }

  /** Whether a question waits for an answer. */
  boolean asks() {
    return window.asks();
  }

  /** Asks something in the window. */
  void ask(Question question) {
    window.ask(question);
  }

  /** Ends the window's part of it; the stage stays. */
  void leave() {
    recording.unsubscribe();
    window.close();
  }

  /** Lets go of the settings, so that another scenario can have them. */
  void forget() {
    window.forget(frame.settings);
  }

  /** Ends simulation, video and recording. For any thread. */
  @Override
  public void close() {
    video.close();
    simulation.close();
    recorder.close();
  }
}
