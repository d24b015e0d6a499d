package tellosimulator.view.app;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javafx.application.Application;
import javafx.beans.value.ObservableValue;
import javafx.geometry.Orientation;
import javafx.geometry.Pos;
import javafx.scene.Parent;
import javafx.scene.Scene;
import javafx.scene.control.Label;
import javafx.scene.input.KeyCombination;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import javafx.stage.Stage;
import javafx.util.Subscription;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.view.controls.ContactHint;
import tellosimulator.view.controls.DroneList;
import tellosimulator.view.controls.LastCommandRow;
import tellosimulator.view.controls.NetworkControls;
import tellosimulator.view.controls.SimulatorControls;
import tellosimulator.view.fx.FileDrop;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.gallery.GalleryPane;
import tellosimulator.view.goal.GoalPanel;
import tellosimulator.view.layout.KeyBindings;
import tellosimulator.view.layout.PageOverlay;
import tellosimulator.view.layout.ScenarioMenu;
import tellosimulator.view.layout.SimulatorPane;
import tellosimulator.view.layout.Theme;
import tellosimulator.view.layout.WindowBar;
import tellosimulator.view.layout.WindowCommands;
import tellosimulator.view.layout.WindowKey;
import tellosimulator.view.layout.WindowState;
import tellosimulator.view.layout.WindowState.Flag;
import tellosimulator.view.log.LogLevel;
import tellosimulator.view.log.LogPane;
import tellosimulator.view.log.LogQueue;
import tellosimulator.view.model.FxScenario;
import tellosimulator.view.model.ScenarioActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.pilot.PilotControls;
import tellosimulator.view.plan.PlanPane;
import tellosimulator.view.projector.ProjectorPane;
import tellosimulator.view.settings.Settings;
import tellosimulator.view.text.Messages;
import tellosimulator.view.world.Simulator3DScene;
import tellosimulator.view.world.ViewCamera;

/** The simulator's window, assembled from its parts. Confined to the JavaFX thread. */
final class SimulatorWindow implements AutoCloseable {

  /**
   * Initial width of the scene, used until the window has a size [px]. Measured: without it, the
   * toolkit computes a width by applying all styles once more; this takes a tenth of the startup
   * time.
   */
  private static final double FIRST_WIDTH = 1280;

  /** Initial height of the scene, used until the window has a size [px]. */
  private static final double FIRST_HEIGHT = 800;

  /** Vertical gap between the parts that float over the scene [px]. */
  private static final double ASIDE_GAP = 8;

  private static final Pattern SCENARIO_FILE = Pattern.compile("(?i).*\\.ya?ml");

  /**
   * Width of the scene below which the goals and the list of drones are folded, and the buttons
   * over the scene have no labels [px]. Measured: the width of the labelled buttons in German,
   * without the power switch.
   */
  private static final double NARROW = 600;

  /**
   * Like {@link #NARROW}, but for a window that shows the power switch [px]. Measured: the width of
   * the labelled buttons in German, with the power switch.
   */
  private static final double NARROW_WITH_POWER = 730;

  /**
   * The maximum number of drones for which the list of drones is initially open. Decided: a longer
   * list hides too much of the room.
   */
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
   * Builds the window without showing it.
   *
   * @param state the window's state
   * @param logQueue the source of the window's log
   */
  public SimulatorWindow(Stage stage, ViewContext context, WindowState state, LogQueue logQueue) {
    this.stage = stage;
    this.context = context;
    this.state = state;
    // Must come first: without a style sheet, the first control would load the toolkit's default
    // one.
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
    Nodes.addCommonStyles(root);
    FileDrop.install(root, this::open);
    scene = scene(stage, root);
    following = stage.fullScreenProperty().subscribe(state.flag(Flag.FULL_SCREEN)::set);
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

  /**
   * Opens a dropped file: as a scenario if its name ends in .yaml or .yml, otherwise as a
   * recording.
   */
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
   * Returns the stage's scene after replacing its root. The scene is created only once per stage: a
   * new scene would impose its own size on a maximised window and would end full-screen mode.
   */
  private static Scene scene(Stage stage, Parent root) {
    if (stage.getScene() == null) {
      stage.setScene(new Scene(root, FIRST_WIDTH, FIRST_HEIGHT));
    } else {
      stage.getScene().setRoot(root);
    }
    return stage.getScene();
  }

  /** Keeps a subscription until the window is closed. */
  private void follow(Subscription subscription) {
    following = following.and(subscription);
  }

  private VBox notices() {
    Messages messages = context.language().messages(NetworkControls.class);
    Label paused = Nodes.named(messages.label("paused"), "pause-notice");
    paused.setGraphic(new FontIcon(Feather.PAUSE));
    Nodes.showIf(paused, context.simulation().pausedProperty());
    VBox notices =
        new VBox(
            ASIDE_GAP, paused, new LastCommandRow(context, "last-command", Orientation.HORIZONTAL));
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

  /** Wakes the ticker on any input or resizing, so that the next frame shows the effect. */
  private void setupPulse() {
    follow(InputActivity.subscribe(context.ticker()::wake));
    follow(scene.widthProperty().subscribe(context.ticker()::wake));
    follow(scene.heightProperty().subscribe(context.ticker()::wake));
  }

  private void setupKeys() {
    follow(pilot.install(scene)); // first, so that its keys take precedence
    WindowKeys actions = new WindowKeys(this, context, state, stage);
    KeyBindings keys = actions.bindings();
    bar.scenarios().onNextGroup(actions::nextGroup);
    WindowCommands commands = new WindowCommands(context, state, keys);
    keys.on(WindowKey.COMMANDS, () -> pages.togglePalette(commands));
    bar.addMenu(context.language(), commands);
    follow(keys.install(scene));
    follow(ProjectorMode.install(scene, state));
    pilot.keyboard().activeProperty().subscribe(this::giveKeysToDrone);
  }

  private void setupBindings() {
    boolean several = context.simulation().drones().size() > 1;
    Nodes.showIf(drones, state.flag(Flag.DRONES).map(shown -> shown && several));
    world.setCovers(
        Stream.concat(Stream.of(goals, drones, pilot), projector.boxes().stream()).toList());
    context
        .scenario()
        .challengeProperty()
        .subscribe(challenge -> world.setGoals(challenge.goals()));
    world.camera().reducedMotionProperty().bind(state.flag(Flag.REDUCED_MOTION));
    log.openProperty().bindBidirectional(state.flag(Flag.LOG));
    pilot.powerShownProperty().bind(state.flag(Flag.NETWORK_CONTROLS).not());
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
    plan.shownProperty().bindBidirectional(state.flag(Flag.PLAN));
    plan.shownProperty().subscribe(this::giveKeys);
    follow(state.flag(Flag.FULL_SCREEN).subscribe(stage::setFullScreen));
    projector.visibleProperty().bind(state.flag(Flag.PROJECTOR));
    world.showInsetWhile(state.flag(Flag.PROJECTOR).not());
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

  /**
   * Moves the focus to the scene when keyboard flight begins, because a focused button would
   * consume the keys.
   */
  private void giveKeysToDrone(boolean flies) {
    if (flies) {
      world.requestFocus();
    }
  }

  private static boolean narrow(double width, boolean withPower) {
    return width < (withPower ? NARROW_WITH_POWER : NARROW);
  }

  /**
   * Adapts the parts over the scene to the scene's width. Folds the list of drones if the scene is
   * narrow, or if there are goals or many drones.
   */
  private void fit(boolean narrow) {
    boolean few = context.simulation().drones().size() <= FEW_DRONES;
    pilot.narrowProperty().set(narrow);
    foldGoals(narrow);
    drones.unfold(!narrow && few && context.scenario().challenge().goals().isEmpty());
  }

  /** Folds the goals if the scene is narrow or shows the drone's video; otherwise unfolds them. */
  private void foldGoals(boolean narrow) {
    goals.unfold(!narrow && world.viewCameraProperty().get() != ViewCamera.DRONE);
  }

  /**
   * Ends keyboard flight when the plan opens, because the keys would otherwise steer a hidden
   * drone. Moves the focus back to the scene when the plan closes.
   */
  private void giveKeys(boolean toPlan) {
    if (toPlan) {
      pilot.keyboard().activeProperty().set(false);
    } else {
      world.requestFocus();
    }
  }

  /**
   * Restores the parts of the window from the settings, and saves their changes until the window is
   * closed.
   */
  void remember(Settings settings) {
    follow(memory.remember(settings));
    context.ticker().onTick(settings::beat);
  }

  /** Starts updating the window, and opens its stage unless the stage is already open. */
  void show() {
    context.ticker().start();
    boolean opens = !stage.isShowing();
    stage.show();
    world.requestFocus(); // otherwise Space would press the first button
    if (opens) {
      InitialStageSize.hold(stage);
      FrameRateLog.begin();
    }
  }

  Simulator3DScene world() {
    return world;
  }

  /** Moves all drones back to their starts. */
  void again() {
    goals.again();
  }

  /** Restarts the clock of the projector view. */
  void restartClock() {
    projector.restart();
  }

  LogPane log() {
    return log;
  }

  PlanPane plan() {
    return plan;
  }

  PageOverlay pages() {
    return pages;
  }

  /** Returns the menu that opens and saves scenarios. */
  ScenarioMenu files() {
    return bar.scenarios();
  }

  /** Opens the gallery, or closes it if it is open. */
  void toggleGallery(GalleryPane.Offer offer) {
    pages.toggleGallery(offer, bar.scenarios()::chooseToOpen);
  }

  /**
   * Releases everything except the stage. The log of the next window takes over the rows of this
   * log.
   */
  @Override
  public void close() {
    following.unsubscribe();
    context.actions().close();
    context.ticker().stop();
    world.rest();
    pilot.close();
    log.handOver();
  }
}
