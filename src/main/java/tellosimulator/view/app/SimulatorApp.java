package tellosimulator.view.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import javafx.application.Platform;
import javafx.stage.FileChooser;
import javafx.stage.Stage;
import tellosimulator.goal.Challenge;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.PortTakenException;
import tellosimulator.recording.FlightResult;
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
import tellosimulator.view.layout.WindowState.Flag;
import tellosimulator.view.log.LogLevel;
import tellosimulator.view.log.LogQueue;
import tellosimulator.view.model.ScenarioActions;
import tellosimulator.view.model.StartSettings;
import tellosimulator.view.plan.PlanEditorState;
import tellosimulator.view.replay.ReplayWindow.Appearance;
import tellosimulator.view.settings.Settings;
import tellosimulator.view.settings.WindowPlacement;
import tellosimulator.view.text.Language;
import tellosimulator.web.ScenarioHost;
import tellosimulator.world.Arena;

/** The simulator program with a window, in which scenarios can be opened one after another. */
public final class SimulatorApp implements AutoCloseable, ScenarioActions {

  /**
   * The rules that apply to every scenario.
   *
   * @param applied applies the command-line options to a scenario; throws an {@link
   *     IllegalArgumentException} with a message for the user if they do not fit the scenario
   * @param plan assigns the address at which each drone listens; throws an {@link
   *     IllegalArgumentException} with a message for the user if a drone cannot be assigned an
   *     address
   * @param replyPort the port to which all replies go; if empty, each reply goes to the port from
   *     which its command came
   * @param recordings the settings for recording flights
   */
  public record Rules(
      UnaryOperator<Scenario> applied,
      Function<Scenario, AddressPlan> plan,
      OptionalInt replyPort,
      Recordings recordings) {}

  /**
   * The settings for recording flights.
   *
   * @param always whether flights are recorded even if the window's setting is off
   * @param options the command-line arguments of the program
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
  private RecentFiles assignments;
  private SolvedScenarios solved;
  private RecordingPlayers players;
  private boolean galleryFirst;
  private Optional<FileWatcher> watch = Optional.empty();

  /**
   * Starts the simulation with all drones off.
   *
   * @param optics the optics of the drones' cameras
   */
  public SimulatorApp(OpenedScenario first, Rules rules, DroneOptics optics) {
    this(first, rules, optics, SystemBrowser::open);
  }

  /**
   * @param reportOpener opens a report for the user and returns whether this succeeded
   */
  SimulatorApp(
      OpenedScenario first, Rules rules, DroneOptics optics, Predicate<Path> reportOpener) {
    this.rules = rules;
    this.optics = optics;
    report = new LastFlightReport(rules.recordings.folder(), logQueue, reportOpener);
    AddressPlan plan = rules.plan.apply(first.scenario());
    running = new ScenarioSession(EditedScenario.of(first), wireOf(plan), optics, logQueue);
  }

  /**
   * Returns the settings for the communication of another scenario. The drones of that scenario
   * will be reachable from the same machines as the current drones.
   */
  private Wire wire(Scenario scenario) {
    AddressPlan plan = rules.plan.apply(scenario).withReach(running.simulation().reach());
    return wireOf(plan);
  }

  private Wire wireOf(AddressPlan plan) {
    return new Wire(plan, rules.replyPort, rules.recordings);
  }

  /**
   * Switches all drones on. If one of them cannot be switched on, all stay off.
   *
   * @throws PortTakenException if an address or port is not available
   */
  public void switchAllOn() throws PortTakenException {
    running.simulation().switchAllOn();
  }

  /**
   * Returns the addresses at which the drones listen; see {@link
   * tellosimulator.network.OnlineSimulation#ready}.
   */
  public String ready() {
    return running.simulation().ready();
  }

  /**
   * Opens the window and waits until it is closed. The {@link Toolkit} must be running.
   *
   * @param settings the settings to restore and save
   * @param state the state of the window
   * @return whether the window was shown; if not, the reason is logged
   */
  public boolean run(Settings settings, WindowState state) throws InterruptedException {
    return Toolkit.run(stage -> show(stage, settings, state));
  }

  /** Returns the window's scenarios, for the teacher's board. */
  public ScenarioHost host() {
    return new WindowHost(
        () -> running,
        (chosen, seed) -> {
          if (frame != null) { // the window is open
            unlessLost(() -> replaceBy(chosen, seed));
          }
        });
  }

  /** Makes the window open with the gallery if there are no settings from an earlier start. */
  public void beginWithGallery() {
    galleryFirst = true;
  }

  /** Shows the window in a stage. Called on the JavaFX thread. */
  void show(Stage stage, Settings settings, WindowState state) {
    Language language = new Language(Locale.getDefault());
    settings.bind("language", language.localeProperty(), Language.codec());
    frame = new Frame(stage, language, state, settings);
    recent = RecentFiles.remembered(settings, "recent-files");
    assignments = RecentFiles.remembered(settings, "assignments");
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
    scenario.window().log().offer(report);
    watch = scenario.opened().file().map(FileWatcher::new);
    scenario.ticker().onTick(this::lookAtFile);
    scenario.ticker().onTick(nanos -> lookForFlight());
    scenario.opened().known().ifPresent(name -> scenario.onSolved(() -> solved.add(name)));
  }

  private void lookForFlight() {
    boolean recorded = rules.recordings.always() || frame.state().flag(Flag.RECORDED_FLIGHTS).get();
    report.update(recorded, frame.language().translation());
  }

  private void lookAtFile(long nanos) {
    if (watch.isPresent() && watch.get().changed(nanos)) {
      // not within a tick, because the session may end
      Platform.runLater(() -> running.whenSettled(this::fileChanged));
    }
  }

  private void fileChanged() {
    if (running.unsaved() && running.window().pages().asks()) {
      return; // one question at a time; saving checks the file again
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
    running.window().toggleGallery(new GalleryPane.Offer(pictures, recent, solved));
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

  @Override
  public void gradeFlight() {
    FileChooser chooser = new FileChooser();
    chooser.setTitle(frame.language().messages(SimulatorApp.class).now("choose-assignment"));
    assignments
        .latest()
        .ifPresent(
            file -> {
              chooser.setInitialDirectory(file.getParent().toFile());
              chooser.setInitialFileName(file.getFileName().toString());
            });
    Optional.ofNullable(chooser.showOpenDialog(frame.stage()))
        .ifPresent(file -> gradeFlight(file.toPath()));
  }

  /** Grades the last flight, and remembers the assignment. */
  void gradeFlight(Path assignment) {
    assignments.add(assignment);
    report.grade(assignment);
  }

  private void cannotPlay(Function<Language, String> reason) {
    logQueue.say(LogLevel.ERROR, reason);
    String sentence = reason.apply(frame.language());
    running
        .window()
        .pages()
        .ask(new Question("recording", sentence, List.of(new Answer("close", () -> {}))));
  }

  private void openFile(Path file) {
    try {
      replaceBy(OpenedScenario.of(ScenarioFile.open(file), file));
      recent.add(file);
    } catch (ScenarioException e) {
      complain(e);
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
  public void openNextCourse() {
    unlessLost(
        () -> {
          OpenedScenario opened = running.opened();
          long next = opened.scenario().config().seed() + 1;
          replaceBy(opened, OptionalLong.of(next));
        });
  }

  @Override
  public void restart(StartSettings settings) {
    ask(
        "restart",
        new Answer("begin", () -> unlessLost(() -> begin(settings))),
        new Answer("go-on", () -> {}));
  }

  private void begin(StartSettings settings) {
    optics = settings.optics();
    OpenedScenario begun = running.asItBegins();
    boolean sameCourse = !begun.varies() || settings.seed() == begun.scenario().config().seed();
    (sameCourse ? Optional.of(begun) : applied(begun, OptionalLong.of(settings.seed())))
        .ifPresent(
            opened -> {
              Scenario scenario = opened.scenario();
              OpenedScenario next =
                  opened.with(scenario.withConfig(settings.appliedTo(scenario.config())));
              begin(EditedScenario.of(next), wire(next.scenario()));
            });
  }

  @Override
  public boolean replan(Arena arena, List<PlannedDrone> drones, Challenge challenge) {
    EditedScenario next = running.present().planned(arena, drones, challenge);
    Optional<Wire> wire = orComplaint(next.opened(), () -> wire(next.present()));
    wire.ifPresent(
        reached -> {
          PlanEditorState planned = running.window().plan().memory();
          begin(next, reached);
          running.window().plan().goOn(planned);
        });
    return wire.isPresent();
  }

  /**
   * Returns the value of a supplier. If the supplier throws an exception because the value is
   * invalid for a scenario, returns empty and shows the reason in the window.
   */
  private <T> Optional<T> orComplaint(OpenedScenario scenario, Supplier<T> value) {
    try {
      return Optional.of(value.get());
    } catch (IllegalArgumentException e) {
      complain(scenario, e);
      return Optional.empty();
    }
  }

  private void complain(OpenedScenario scenario, IllegalArgumentException e) {
    complain(List.of(language -> title(scenario, language) + ": " + e.getMessage()));
  }

  /**
   * Runs an action. If there are unsaved changes, the user first decides what happens to them, and
   * may cancel the action.
   */
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
          running.window().files().save();
          running.whenSettled( // saving may fail, or the user may cancel it
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
    running
        .window()
        .pages()
        .ask(new Question(key, title(running.opened(), frame.language()), List.of(answers)));
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

  /**
   * Applies the command-line options to the chosen scenario, and begins a session with it. If the
   * options do not fit, the current session continues, and the window shows the reason.
   */
  private void replaceBy(OpenedScenario chosen) {
    replaceBy(chosen, OptionalLong.empty());
  }

  /**
   * @param seed the seed of its course; if empty, that of the rules or of the scenario
   */
  private void replaceBy(OpenedScenario chosen, OptionalLong seed) {
    applied(chosen, seed)
        .ifPresent(
            next ->
                orComplaint(chosen, () -> wire(next.scenario()))
                    .ifPresent(wire -> begin(EditedScenario.of(next), wire)));
  }

  /**
   * Returns the chosen scenario with the course of a seed and with the rules for all scenarios. If
   * that is impossible, returns empty and shows the reason in the window.
   */
  private Optional<OpenedScenario> applied(OpenedScenario chosen, OptionalLong seed) {
    try {
      return Optional.of(chosen.under(rules.applied, seed));
    } catch (ScenarioException e) {
      complain(e);
    } catch (IllegalArgumentException e) {
      complain(chosen, e);
    }
    return Optional.empty();
  }

  /** Ends the current session and begins a new one in the same stage. */
  private void begin(EditedScenario next, Wire wire) {
    boolean on = running.on();
    running.leave();
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

  private void complain(ScenarioException e) {
    complain(e.diagnostics().stream().map(SimulatorApp::saying).toList());
  }

  private void complain(List<Function<Language, String>> diagnostics) {
    diagnostics.forEach(diagnostic -> logQueue.say(LogLevel.ERROR, diagnostic));
    running.window().pages().show(diagnostics);
  }

  @Override
  public void close() {
    running.close();
  }

  /** Returns the outcome of the present scenario. Must be called after {@link #close}. */
  public FlightResult result() {
    return running.result();
  }
}
