package tellosimulator.view.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import javafx.application.Platform;
import javafx.stage.Stage;
import tellosimulator.goal.Challenge;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.PortTakenException;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.scenario.Diagnostic;
import tellosimulator.scenario.EditedScenario;
import tellosimulator.scenario.Gallery;
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.scenario.PlannedDrone;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenario.ScenarioDocument;
import tellosimulator.scenario.ScenarioException;
import tellosimulator.scenario.ScenarioFile;
import tellosimulator.sim.SimConfig;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.app.ScenarioSession.Frame;
import tellosimulator.view.app.ScenarioSession.Wire;
import tellosimulator.view.gallery.GalleryPane;
import tellosimulator.view.gallery.RecentFiles;
import tellosimulator.view.gallery.RoomPictures;
import tellosimulator.view.gallery.SolvedScenarios;
import tellosimulator.view.layout.QuestionPage.Question;
import tellosimulator.view.layout.QuestionPage.Question.Answer;
import tellosimulator.view.layout.WindowState;
import tellosimulator.view.log.LogLevel;
import tellosimulator.view.log.LogQueue;
import tellosimulator.view.model.ScenarioActions;
import tellosimulator.view.model.StartSettings;
import tellosimulator.view.plan.PlanEditorState;
import tellosimulator.view.replay.ReplayWindow.Appearance;
import tellosimulator.view.settings.Settings;
import tellosimulator.view.settings.WindowPlacement;
import tellosimulator.view.text.Language;
import tellosimulator.world.Arena;

/** The program with a window, in which one scenario after the other can be opened. */
public final class SimulatorApp implements AutoCloseable, ScenarioActions {

  /**
   * What holds for every scenario.
   *
   * @param applied gives a scenario what was said about all; fails with a sentence if it cannot
   * @param plan says which drone listens where; fails with a sentence if it cannot
   * @param replyPort port to which all replies go; empty for the port each command came from
   * @param recordings where flights are recorded
   */
  public record Rules(
      UnaryOperator<Scenario> applied,
      Function<Scenario, AddressPlan> plan,
      OptionalInt replyPort,
      Recordings recordings) {}

  /**
   * Where flights are recorded.
   *
   * @param always whether they are, even if the window says otherwise
   * @param options words of the command line
   */
  public record Recordings(RecordingFolder folder, boolean always, List<String> options) {

    public Recordings {
      options = List.copyOf(options);
    }
  }

  private final LogQueue logQueue = new LogQueue();
  private final ScenarioWriter writer = new ScenarioWriter(logQueue);
  private final Rules rules;
  private DroneOptics optics;
  private final LastFlightReport report;
  private volatile ScenarioSession running;
  private final RoomPictures pictures = new RoomPictures();
  private Frame frame;
  private RecentFiles recent;
  private SolvedScenarios solved;
  private RecordingPlayers players;
  private boolean galleryFirst;
  private Optional<FileWatcher> watch = Optional.empty();

  /**
   * Starts the simulation; all drones are off.
   *
   * @param optics of the drones' cameras
   */
  public SimulatorApp(OpenedScenario first, Rules rules, DroneOptics optics) {
    this(first, rules, optics, SystemBrowser::open);
  }

  /**
   * @param reportOpener shows a report to people; says whether it could
   */
  SimulatorApp(
      OpenedScenario first, Rules rules, DroneOptics optics, Predicate<Path> reportOpener) {
    this.rules = rules;
    this.optics = optics;
    report = new LastFlightReport(rules.recordings.folder(), logQueue, reportOpener);
    AddressPlan plan = rules.plan.apply(first.scenario());
    running = new ScenarioSession(EditedScenario.of(first), wireOf(plan), optics, logQueue);
  }

  /** How another scenario is reached: from where the present one is. */
  private Wire wire(Scenario scenario) {
    AddressPlan plan = rules.plan.apply(scenario).withReach(running.simulation().reach());
    return wireOf(plan);
  }

  private Wire wireOf(AddressPlan plan) {
    return new Wire(plan, rules.replyPort, rules.recordings);
  }

  /**
   * Switches all drones on, or none.
   *
   * @throws PortTakenException if an address or port cannot be had
   */
  public void switchAllOn() throws PortTakenException {
    running.simulation().switchAllOn();
  }

  /** Which drone listens where; see {@link tellosimulator.network.OnlineSimulation#ready}. */
  public String ready() {
    return running.simulation().ready();
  }

  /**
   * Opens the window, and returns after it was closed. The {@link Toolkit} must run.
   *
   * @param settings what was remembered, and what is to be remembered
   * @param state what the window is switched to
   * @return whether there was a window; if not, the log says why
   */
  public boolean run(Settings settings, WindowState state) throws InterruptedException {
    return Toolkit.run(stage -> show(stage, settings, state));
  }

  /** Lets the window begin with the gallery, where nothing is remembered of an earlier start. */
  public void beginWithGallery() {
    galleryFirst = true;
  }

  /** Shows the window in a stage. For the JavaFX thread. */
  void show(Stage stage, Settings settings, WindowState state) {
    Language language = new Language(Locale.getDefault());
    settings.bind("language", language.localeProperty(), Language.codec());
    frame = new Frame(stage, language, state, settings);
    recent = RecentFiles.remembered(settings);
    solved = SolvedScenarios.remembered(settings);
    running.opened().file().ifPresent(recent::add);
    players =
        new RecordingPlayers(
            new Appearance(language, state.themeProperty(), optics), this::cannotPlay);
    stage.setOnCloseRequest(
        event -> {
          event.consume();
          unlessLost(stage::hide);
        });
    stage.setOnHidden(
        hidden -> {
          running.leave();
          players.closeAll();
          settings.save();
        });
    boolean firstStart = settings.isNew();
    WindowPlacement.remember(stage, settings);
    show(running);
    if (galleryFirst && firstStart) {
      choose();
    }
  }

  private void show(ScenarioSession scenario) {
    scenario.showIn(frame, this);
    scenario.offer(report);
    watch = scenario.opened().file().map(FileWatcher::new);
    scenario.pulse().onBeat(this::lookAtFile);
    scenario.pulse().onBeat(nanos -> lookForFlight());
    scenario.opened().known().ifPresent(name -> scenario.onSolved(() -> solved.add(name)));
  }

  private void lookForFlight() {
    boolean recorded = rules.recordings.always() || frame.state().flightsRecordedProperty().get();
    report.update(recorded, frame.language().translation());
  }

  private void lookAtFile(long nanos) {
    if (watch.isPresent() && watch.get().changed(nanos)) {
      // not within the beat that it ends
      Platform.runLater(() -> running.whenSettled(this::fileChanged));
    }
  }

  private void fileChanged() {
    if (running.unsaved() && running.asks()) {
      return; // one thing after the other; saving looks again
    }
    if (running.unsaved()) {
      ask("file-changed", new Answer("keep", () -> {}), new Answer("read-again", this::readAgain));
    } else {
      readAgain();
    }
  }

  private void readAgain() {
    say(LogLevel.INFO, "scenario-changed", name());
    openAgain();
  }

  private String name() {
    return running.opened().file().map(Path::toString).orElse("");
  }

  // --- opening and saving ---

  @Override
  public void choose() {
    running.toggleGallery(new GalleryPane.Offer(pictures, recent, solved));
  }

  @Override
  public void open(Path file) {
    unlessLost(() -> openFile(file));
  }

  @Override
  public void openEmpty() {
    unlessLost(() -> replaceBy(OpenedScenario.once(Scenario.of(SimConfig.DEFAULT))));
  }

  @Override
  public void openRecording(Path place) {
    players.open(place);
  }

  private void cannotPlay(Function<Language, String> reason) {
    logQueue.say(LogLevel.ERROR, reason);
    String sentence = reason.apply(frame.language());
    running.ask(new Question("recording", sentence, List.of(new Answer("close", () -> {}))));
  }

  private void openFile(Path file) {
    try {
      replaceBy(OpenedScenario.of(ScenarioFile.open(file), file));
      recent.add(file);
    } catch (ScenarioException e) {
      complain(e.diagnostics().stream().map(SimulatorApp::saying).toList());
    }
  }

  @Override
  public void openKnown(String name) {
    unlessLost(() -> openOfProgram(name));
  }

  private void openOfProgram(String name) {
    Gallery.open(name).ifPresent(known -> replaceBy(OpenedScenario.known(known, name)));
  }

  @Override
  public void reload() {
    unlessLost(this::openAgain);
  }

  private void openAgain() {
    OpenedScenario opened = running.opened();
    opened.file().ifPresent(this::openFile);
    opened.known().ifPresent(this::openOfProgram);
  }

  @Override
  public void beginAnew(StartSettings settings) {
    ask(
        "begin-anew",
        new Answer("begin", () -> unlessLost(() -> begin(settings))),
        new Answer("go-on", () -> {}));
  }

  private void begin(StartSettings settings) {
    optics = settings.optics();
    OpenedScenario opened = running.asItBegins();
    Scenario scenario = opened.scenario();
    OpenedScenario next = opened.with(scenario.withConfig(settings.appliedTo(scenario.config())));
    begin(EditedScenario.of(next), wire(next.scenario()));
  }

  @Override
  public boolean replan(Arena arena, List<PlannedDrone> drones, Challenge challenge) {
    EditedScenario next = running.present().planned(arena, drones, challenge);
    Optional<Wire> wire = wireOrComplaint(next.opened(), next.present());
    wire.ifPresent(
        reached -> {
          PlanEditorState planned = running.planned();
          begin(next, reached);
          running.goOn(planned);
        });
    return wire.isPresent();
  }

  /** How drones are reached; empty if they cannot be, which is told in the window. */
  private Optional<Wire> wireOrComplaint(OpenedScenario opened, Scenario scenario) {
    try {
      return Optional.of(wire(scenario));
    } catch (IllegalArgumentException e) {
      complain(List.of(language -> title(opened, language) + ": " + e.getMessage()));
      return Optional.empty();
    }
  }

  /** Does something, at once or after somebody has said what becomes of unsaved edits. */
  private void unlessLost(Runnable action) {
    running.whenSettled(() -> unlessUnsaved(action));
  }

  private void unlessUnsaved(Runnable action) {
    if (!running.unsaved()) {
      action.run();
      return;
    }
    Runnable saveFirst =
        () -> {
          running.save();
          running.whenSettled( // it may not have worked, or no file was chosen
              () -> {
                if (!running.unsaved()) {
                  action.run();
                }
              });
        };
    ask(
        "unsaved",
        new Answer("save", saveFirst),
        new Answer("do-not-save", action),
        new Answer("go-on", () -> {}));
  }

  private void ask(String key, Answer... answers) {
    running.ask(new Question(key, title(running.opened(), frame.language()), List.of(answers)));
  }

  @Override
  public void save(Path file) {
    running.whenSettled(() -> saveTo(file));
  }

  private void saveTo(Path file) {
    boolean ours = running.opened().file().filter(file::equals).isPresent();
    try {
      if (ours && !ScenarioFile.holds(file, running.opened().document())) {
        ask(
            "overwrite",
            new Answer("go-on", () -> {}),
            new Answer("overwrite-it", () -> write(file)));
        return;
      }
    } catch (IOException e) {
      writer.notSaved(file, e);
      return;
    }
    write(file);
  }

  private void write(Path file) {
    ScenarioDocument document = running.toSave(file);
    if (writer.write(document, file)) {
      running.savedAs(document, file);
      recent.add(file);
      watch = Optional.of(new FileWatcher(file));
    }
  }

  private void say(LogLevel level, String key, Object... about) {
    logQueue.say(level, language -> language.messages(SimulatorApp.class).now(key, about));
  }

  /** Ends what is flown and begins something else, with what holds for every scenario. */
  private void replaceBy(OpenedScenario chosen) {
    OpenedScenario next;
    Wire wire;
    try {
      next = chosen.with(rules.applied.apply(chosen.scenario()));
      wire = wire(next.scenario());
    } catch (IllegalArgumentException e) {
      complain(List.of(language -> title(chosen, language) + ": " + e.getMessage()));
      return;
    }
    begin(EditedScenario.of(next), wire);
  }

  /** Ends what is flown and begins something else, in the same stage. */
  private void begin(EditedScenario next, Wire wire) {
    boolean on = running.on();
    running.leave();
    running.forget();
    running.close();
    running = new ScenarioSession(next, wire, optics, logQueue);
    logQueue.say(
        LogLevel.INFO,
        language ->
            language
                .messages(SimulatorApp.class)
                .now("scenario-opened", title(next.opened(), language)));
    show(running);
    if (on) {
      running.switchOn();
    }
  }

  private static String title(OpenedScenario opened, Language language) {
    return opened
        .file()
        .map(Path::toString)
        .orElseGet(() -> opened.scenario().description().name().in(language.locale()));
  }

  private static Function<Language, String> saying(Diagnostic diagnostic) {
    return language -> diagnostic.in(language.translation());
  }

  private void complain(List<Function<Language, String>> diagnostics) {
    diagnostics.forEach(diagnostic -> logQueue.say(LogLevel.ERROR, diagnostic));
    running.show(diagnostics);
  }

  @Override
  public void close() {
    running.close();
  }
}
