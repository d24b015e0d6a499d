package tellosimulator.view.app;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Function;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javafx.application.Application;
import javafx.beans.property.BooleanProperty;
import javafx.beans.value.ObservableValue;
import javafx.geometry.Orientation;
import javafx.geometry.Pos;
import javafx.scene.Parent;
import javafx.scene.Scene;
import javafx.scene.input.KeyCombination;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import javafx.stage.Stage;
import javafx.stage.WindowEvent;
import javafx.util.Subscription;
import tellosimulator.sim.Control;
import tellosimulator.view.controls.ContactHint;
import tellosimulator.view.controls.DroneList;
import tellosimulator.view.controls.LastCommandRow;
import tellosimulator.view.controls.NetworkControls;
import tellosimulator.view.controls.PauseNotice;
import tellosimulator.view.controls.SimulatorControls;
import tellosimulator.view.fx.CommonStyles;
import tellosimulator.view.fx.FileDrop;
import tellosimulator.view.gallery.GalleryPane;
import tellosimulator.view.goal.GoalPanel;
import tellosimulator.view.layout.KeyBindings;
import tellosimulator.view.layout.PageOverlay;
import tellosimulator.view.layout.QuestionPage.Question;
import tellosimulator.view.layout.SimulatorPane;
import tellosimulator.view.layout.Theme;
import tellosimulator.view.layout.WindowBar;
import tellosimulator.view.layout.WindowCommands;
import tellosimulator.view.layout.WindowKey;
import tellosimulator.view.layout.WindowState;
import tellosimulator.view.log.LogLevel;
import tellosimulator.view.log.LogPane;
import tellosimulator.view.log.LogQueue;
import tellosimulator.view.log.ReportOffer;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxScenario;
import tellosimulator.view.model.ScenarioActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.pilot.PilotControls;
import tellosimulator.view.plan.PlanEditorState;
import tellosimulator.view.plan.PlanPane;
import tellosimulator.view.projector.ProjectorPane;
import tellosimulator.view.settings.Settings;
import tellosimulator.view.text.Language;
import tellosimulator.view.video.VideoCapture;
import tellosimulator.view.world.RoomView;
import tellosimulator.view.world.Simulator3DScene;
import tellosimulator.view.world.ViewCamera;

/** The window: its parts, put together. For the JavaFX thread. */
final class SimulatorWindow implements AutoCloseable {

  /**
   * Size of the scene before the window has its own [px]. Measured: without one, the toolkit styles
   * everything once more to find it, which takes a tenth of the start.
   */
  private static final double FIRST_WIDTH = 1280;

  private static final double FIRST_HEIGHT = 800;

  /** Between what lies over the scene's corner [px]. */
  private static final double ASIDE_GAP = 8;

  private static final Pattern SCENARIO_FILE = Pattern.compile("(?i).*\\.ya?ml");

  /**
   * Width of the scene below which goals and drones are folded, and buttons over it have no words
   * [px]. Measured: what the buttons need with words, in German; with the power switch, and
   * without.
   */
  private static final double NARROW = 600;

  private static final double NARROW_WITH_POWER = 730;

  /** So many drones are listed at first. Decided: the list of more pushes the room aside. */
  private static final int FEW_DRONES = 5;

  private final Stage stage;
  private final ViewContext context;
  private final WindowState state;
  private final Simulator3DScene world;
  private final PilotControls pilot;
  private final SimulatorControls simulatorControls;
  private final NetworkControls networkControls;
  private final DroneList drones;
  private final PlanPane plan;
  private final LogPane log;
  private final PageOverlay pages;
  private final WindowBar bar;
  private final GoalPanel goals;
  private final ProjectorPane projector;
  private final ContactHint hint;
  private final SimulatorPane pane;
  private final WindowSettings memory;
  private final Scene scene;
  private Subscription following;

  /**
   * Builds the window, and does not show it yet.
   *
   * @param state what it is switched to
   * @param logQueue what its log shows
   */
  public SimulatorWindow(Stage stage, ViewContext context, WindowState state, LogQueue logQueue) {
    this.stage = stage;
    this.context = context;
    this.state = state;
    // First: the first control would load the toolkit's own looks, if there were no others.
    state
        .themeProperty()
        .subscribe(theme -> Application.setUserAgentStylesheet(theme.stylesheet()));
    world = new Simulator3DScene(context.scene());
    world.dimmedProperty().bind(state.themeProperty().map(theme -> theme == Theme.DARK));
    pilot = new PilotControls(context);
    simulatorControls = new SimulatorControls(context);
    networkControls = new NetworkControls(context);
    goals = new GoalPanel(context);
    drones = new DroneList(context);
    plan = new PlanPane(context);
    log = new LogPane(context, logQueue);
    pages = new PageOverlay(context);
    bar = new WindowBar(context, state, world, pages);
    projector = new ProjectorPane(context);
    hint = new ContactHint(context, words -> logQueue.say(LogLevel.WARN, words));
    memory = new WindowSettings(context, world, log, simulatorControls, networkControls);
    pane = pane();
    Parent root = new StackPane(pane, projector, pages);
    CommonStyles.install(root);
    FileDrop.install(root, this::open);
    scene = scene(stage, root);
    following = stage.fullScreenProperty().subscribe(state.fullScreenProperty()::set);
    setupKeys();
    setupPulse();
    setupBindings();
    context.actions().onRefused((refusal, drone) -> logQueue.cannotSwitchOn(drone, refusal));
    context
        .video()
        .onReport(
            report ->
                logQueue.say(
                    report.good() ? LogLevel.INFO : LogLevel.ERROR,
                    report.drone(),
                    report.phrase()));
    follow(state.themeProperty().subscribe(theme -> scene.setFill(theme.background())));
    follow(context.scenario().fileProperty().subscribe(file -> stage.setTitle(title())));
    follow(context.scenario().unsavedProperty().subscribe(unsaved -> stage.setTitle(title())));
    follow(context.language().localeProperty().subscribe(locale -> stage.setTitle(title())));
    stage.setFullScreenExitHint("");
    stage.setFullScreenExitKeyCombination(KeyCombination.NO_MATCH);
  }

  /** Opens what was dropped: the file of a scenario, or else a recording. */
  private void open(Path dropped) {
    ScenarioActions actions = context.scenario().actions();
    boolean recording = !SCENARIO_FILE.matcher(String.valueOf(dropped.getFileName())).matches();
    if (recording || Files.isDirectory(dropped)) {
      actions.openRecording(dropped);
    } else {
      actions.open(dropped);
    }
  }

  private String title() {
    FxScenario scenario = context.scenario();
    String name =
        scenario
            .file()
            .map(file -> file.getFileName().toString())
            .orElse(scenario.scenario().description().name().in(context.language().locale()));
    String mark = scenario.unsavedProperty().get() ? "* " : "";
    return mark + (name.isEmpty() ? "Tello Simulator" : name + " – Tello Simulator");
  }

  /**
   * The stage's only scene, which now shows this. Another scene would bring its own size into a
   * window that is maximised, and leave full screen.
   */
  private static Scene scene(Stage stage, Parent root) {
    if (stage.getScene() == null) {
      stage.setScene(new Scene(root, FIRST_WIDTH, FIRST_HEIGHT));
    } else {
      stage.getScene().setRoot(root);
    }
    return stage.getScene();
  }

  /** Follows something until the window is closed. */
  private void follow(Subscription subscription) {
    following = following.and(subscription);
  }

  private VBox notices() {
    VBox notices =
        new VBox(
            ASIDE_GAP,
            new PauseNotice(context),
            new LastCommandRow(context, "last-command", Orientation.HORIZONTAL));
    notices.setAlignment(Pos.CENTER);
    notices.setFillWidth(false);
    notices.setMouseTransparent(true);
    return notices;
  }

  private SimulatorPane pane() {
    return new SimulatorPane(
        new SimulatorPane.Parts(
            bar,
            new SimulatorPane.Middle(
                world, new VBox(ASIDE_GAP, hint, goals, drones), notices(), pilot, plan),
            simulatorControls,
            networkControls,
            log),
        state);
  }

  /** Whatever a person does here, the window shows it with the next frame. */
  private void setupPulse() {
    follow(InputActivity.subscribe(context.pulse()::wake));
    follow(scene.widthProperty().subscribe(context.pulse()::wake));
    follow(scene.heightProperty().subscribe(context.pulse()::wake));
  }

  private void setupKeys() {
    follow(pilot.install(scene)); // first: while it is on, its keys go before the window's
    KeyBindings keys = keys();
    WindowCommands commands = new WindowCommands(context, state, keys);
    keys.on(WindowKey.COMMANDS, () -> pages.togglePalette(commands));
    bar.addMenu(context.language(), commands);
    follow(keys.install(scene));
    follow(ProjectorMode.install(scene, state));
    pilot.keyboard().activeProperty().subscribe(this::giveKeysToDrone);
  }

  private KeyBindings keys() {
    return new KeyBindings()
        .on(WindowKey.HELP, pages::toggleHelp)
        .on(WindowKey.SIMULATOR_CONTROLS, () -> toggle(state.simulatorControlsShownProperty()))
        .on(WindowKey.NETWORK_CONTROLS, () -> toggle(state.networkControlsShownProperty()))
        .on(WindowKey.LOG, () -> toggle(state.logOpenProperty()))
        .on(WindowKey.DRONES, () -> toggle(state.dronesShownProperty()))
        .on(WindowKey.INSET, () -> toggle(world.insetVisibleProperty()))
        .on(WindowKey.STILL, () -> capture().saveStill())
        .on(WindowKey.PROJECTOR, () -> toggle(state.projectorProperty()))
        .on(WindowKey.RECORD, () -> capture().toggleRecording())
        .on(WindowKey.TRAIL, () -> toggle(world.trailVisibleProperty()))
        .on(WindowKey.GOAL_LINE, () -> toggle(world.goalLineVisibleProperty()))
        .on(WindowKey.PAUSE, context.actions()::togglePause)
        .on(WindowKey.PLAN, () -> toggle(state.planShownProperty()))
        .on(WindowKey.FULL_SCREEN, () -> toggle(state.fullScreenProperty()))
        .on(WindowKey.FRONT_VIEW, () -> world.look(RoomView.FRONT))
        .on(WindowKey.SIDE_VIEW, () -> world.look(RoomView.SIDE))
        .on(WindowKey.TOP_VIEW, () -> world.look(RoomView.TOP))
        .on(WindowKey.CHASE_VIEW, () -> world.look(RoomView.CHASE))
        .on(WindowKey.START_VIEW, () -> world.look(RoomView.START))
        .on(WindowKey.FIT, world::fit)
        .on(WindowKey.FOLLOW, () -> toggle(world.camera().followingProperty()))
        .on(WindowKey.DRONE_CAMERA, world::switchCamera)
        .on(WindowKey.NEXT_DRONE, () -> context.simulation().selectNext(1))
        .on(WindowKey.PREVIOUS_DRONE, () -> context.simulation().selectNext(-1))
        .on(WindowKey.GALLERY, context.scenario().actions()::choose)
        .on(WindowKey.OPEN_SCENARIO, bar.scenarios()::chooseToOpen)
        .on(WindowKey.SAVE_SCENARIO, this::save)
        .on(WindowKey.SAVE_SCENARIO_AS, bar.scenarios()::chooseToSave)
        .on(WindowKey.RELOAD_SCENARIO, context.scenario().actions()::reload)
        .on(WindowKey.AGAIN, goals::again)
        .on(WindowKey.NEXT_GROUP, this::nextGroup)
        .on(WindowKey.SEARCH_LOG, this::searchLog)
        .on(WindowKey.QUIT, this::quit);
  }

  /** As the button of the frame does. */
  private void quit() {
    stage.fireEvent(new WindowEvent(stage, WindowEvent.WINDOW_CLOSE_REQUEST));
  }

  private static void toggle(BooleanProperty property) {
    property.set(!property.get());
  }

  /** Keeps pictures of the selected drone. */
  private VideoCapture capture() {
    return context.video().capture(context.simulation().selected().number());
  }

  private void searchLog() {
    log.startSearch();
  }

  private void setupBindings() {
    boolean several = context.simulation().drones().size() > 1;
    drones.visibleProperty().bind(state.dronesShownProperty().map(shown -> shown && several));
    drones.managedProperty().bind(drones.visibleProperty());
    world.setCovers(
        Stream.concat(Stream.of(goals, drones, pilot), projector.boxes().stream()).toList());
    context
        .scenario()
        .challengeProperty()
        .subscribe(challenge -> world.setGoals(challenge.goals()));
    world.camera().reducedMotionProperty().bind(state.reducedMotionProperty());
    log.openProperty().bindBidirectional(state.logOpenProperty());
    pilot.powerShownProperty().bind(state.networkControlsShownProperty().not());
    simulatorControls.availableHeightProperty().bind(pane.sideHeight());
    networkControls.availableHeightProperty().bind(pane.sideHeight());
    ObservableValue<Boolean> narrow =
        pilot
            .powerShownProperty()
            .flatMap(
                shown -> pane.freeWidthProperty().map(width -> narrow(width.doubleValue(), shown)));
    narrow.subscribe(this::fit);
    context
        .scenario()
        .challengeProperty()
        .map(asked -> asked.goals().isEmpty())
        .subscribe(none -> fit(narrow.getValue()));
    plan.shownProperty().bindBidirectional(state.planShownProperty());
    plan.shownProperty().subscribe(this::giveKeys);
    follow(state.fullScreenProperty().subscribe(stage::setFullScreen));
    projector.visibleProperty().bind(state.projectorProperty());
    world.showInsetWhile(state.projectorProperty().not());
    bar.scenarios().onNextGroup(this::nextGroup);
    simulatorControls
        .droneCameraProperty()
        .subscribe(
            drone ->
                world.viewCameraProperty().set(drone ? ViewCamera.DRONE : ViewCamera.SIMULATOR));
    world
        .viewCameraProperty()
        .subscribe(
            camera -> {
              simulatorControls.droneCameraProperty().set(camera == ViewCamera.DRONE);
              foldGoals(narrow.getValue());
            });
  }

  /** Leaves nothing of those who flew before: operators, drones, batteries, paths, log, clock. */
  private void nextGroup() {
    for (FxDroneModel drone : context.simulation().drones()) {
      context.actions().carryOut(new Control.Reset(drone.number()));
      context.actions().carryOut(new Control.Release(drone.number()));
      context.actions().carryOut(new Control.SetBattery(drone.number(), 100));
    }
    context
        .actions()
        .afterPending(
            () -> {
              world.clearTrails();
              log.clear();
              projector.restart();
            });
  }

  /** A button that was reached by keyboard would keep them. */
  private void giveKeysToDrone(boolean flies) {
    if (flies) {
      world.requestFocus();
    }
  }

  private static boolean narrow(double width, boolean withPower) {
    return width < (withPower ? NARROW_WITH_POWER : NARROW);
  }

  /** Leaves room to the scene: where there is more to list, the drones are a line that unfolds. */
  private void fit(boolean narrow) {
    boolean few = context.simulation().drones().size() <= FEW_DRONES;
    pilot.narrowProperty().set(narrow);
    foldGoals(narrow);
    drones.unfold(!narrow && few && context.scenario().challenge().goals().isEmpty());
  }

  /** Nor shall they cover a drone's film. */
  private void foldGoals(boolean narrow) {
    goals.unfold(!narrow && world.viewCameraProperty().get() != ViewCamera.DRONE);
  }

  /** The plan's keys would steer a drone that one does not see. */
  private void giveKeys(boolean toPlan) {
    if (toPlan) {
      pilot.keyboard().activeProperty().set(false);
    } else {
      world.requestFocus();
    }
  }

  /** Is at first as it was left, and remembers how it is left; not where it is. */
  void remember(Settings settings) {
    memory.remember(settings);
    context.pulse().onBeat(settings::beat);
  }

  /** Lets another window of the same program remember. */
  void forget(Settings settings) {
    memory.forget(settings);
  }

  /** Lets one open the report of the last flight. */
  void offer(ReportOffer report) {
    log.offer(report);
  }

  /** Opens it, or takes the place of another one in the same stage. */
  void show() {
    context.pulse().start();
    boolean opens = !stage.isShowing();
    stage.show();
    world.requestFocus(); // or the first button would have it, and Space would press that
    if (opens) {
      InitialStageSize.hold(stage);
      FrameRateLog.begin();
    }
  }

  /** What was planned here, for a window that goes on with it. */
  PlanEditorState planned() {
    return plan.memory();
  }

  /** Goes on with what was planned in another window. */
  void goOn(PlanEditorState planned) {
    plan.goOn(planned);
  }

  /** Says what is wrong with a scenario. */
  void show(List<Function<Language, String>> diagnostics) {
    pages.show(diagnostics);
  }

  /** Lets somebody choose what to fly in, or closes that page. */
  void toggleGallery(GalleryPane.Offer offer) {
    pages.toggleGallery(offer, bar.scenarios()::chooseToOpen);
  }

  /** Asks something. */
  void ask(Question question) {
    pages.ask(question);
  }

  /** Whether a question waits for an answer. */
  boolean asks() {
    return pages.asks();
  }

  /** Saves the scenario to its file, or lets somebody choose one. */
  void save() {
    bar.scenarios().save();
  }

  /** Ends what it does beside showing; what its log showed, the next one shows. */
  @Override
  public void close() {
    following.unsubscribe();
    context.actions().close();
    context.pulse().stop();
    world.rest();
    pilot.close();
    log.handOver();
  }
}
