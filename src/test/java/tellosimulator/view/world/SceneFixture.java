package tellosimulator.view.world;

import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import atlantafx.base.theme.PrimerLight;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.TimeoutException;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javafx.application.Application;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.SubScene;
import javafx.scene.image.Image;
import javafx.scene.image.ImageView;
import javafx.scene.paint.Color;
import javafx.stage.Stage;
import javafx.stage.StageStyle;
import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.testfx.api.FxToolkit;
import tellosimulator.fault.ActiveFaults;
import tellosimulator.fault.Fault;
import tellosimulator.fault.LinkPreset;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.Progress;
import tellosimulator.math.Pose;
import tellosimulator.model.DroneState;
import tellosimulator.model.FlightPhase;
import tellosimulator.model.Motion;
import tellosimulator.scenery.orbit.RoomView;
import tellosimulator.scenery.overlay.ContactDecal;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.time.SimTime;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.model.FxOverlayItems;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SceneContext;
import tellosimulator.view.model.UiTicker;
import tellosimulator.view.testing.WindowFixture;
import tellosimulator.view.text.Language;
import tellosimulator.view.video.MediaFolder;
import tellosimulator.view.video.WindowVideo;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;
import tellosimulator.world.Walls;

/**
 * The 3D scene of a plain room, with snapshots that are created by the test: the drone's position
 * and the passing of time are under the test's control, so that each image is reproducible.
 */
public final class SceneFixture implements BeforeEachCallback, AfterEachCallback {

  static final int WIDTH = 480;

  static final int HEIGHT = 360;

  private final SimConfig config;
  private volatile SimSnapshot snapshot;
  private volatile Progress progress;
  private volatile List<ContactDecal> contacts = List.of();
  private FxSimulation simulation;
  private WindowVideo video;
  private Language language;
  private UiTicker ticker;
  private Simulator3DScene scene;
  private Stage stage;
  private long nanos;

  public SceneFixture() {
    this(SimConfig.DEFAULT.withDecor(Decor.DEFAULT.withWalls(Walls.PLAIN)));
  }

  public SceneFixture(SimConfig config) {
    this.config = config;
  }

  @Override
  public void beforeEach(ExtensionContext test) throws TimeoutException {
    FxToolkit.registerPrimaryStage();
    snapshot = new Simulation(config, drone -> datagram -> {}, List.of()).snapshot();
    ask();
    video = new WindowVideo(() -> snapshot, DroneOptics.DEFAULT, MediaFolder.ofUser());
    onFxThread(
        () -> {
          Application.setUserAgentStylesheet(new PrimerLight().getUserAgentStylesheet());
          simulation = new FxSimulation(snapshot);
          language = new Language(Locale.ENGLISH);
          ticker = new UiTicker(() -> simulation.update(snapshot), simulation::still);
          scene =
              new Simulator3DScene(
                  new SceneContext(
                      simulation,
                      language,
                      ticker,
                      video,
                      new FxOverlayItems(() -> progress, () -> contacts)));
          scene.setPrefSize(WIDTH, HEIGHT);
          scene.antialiasingProperty().set(false); // tests look for single colours
          stage = new Stage(StageStyle.UNDECORATED);
          stage.setScene(new Scene(scene, WIDTH, HEIGHT));
          stage.setWidth(WIDTH);
          stage.setHeight(HEIGHT);
          stage.show();
          scene.requestFocus(); // a focused button has the first drone's colour
          return scene;
        });
    waitUntil(() -> scene.getWidth() == WIDTH && scene.getHeight() == HEIGHT);
    pass(0.02);
  }

  @Override
  public void afterEach(ExtensionContext test) {
    onFxThread(
        () -> {
          scene.rest();
          stage.close();
          return stage;
        });
    video.close();
  }

  Simulator3DScene scene() {
    return scene;
  }

  /** The drones' video. */
  public WindowVideo video() {
    return video;
  }

  /** The snapshot for the next tick. */
  public SimSnapshot snapshot() {
    return snapshot;
  }

  FxSimulation simulation() {
    return simulation;
  }

  Language language() {
    return language;
  }

  /** Returns a node of the 3D scene. */
  Node solid(String id) {
    Node found = ((SubScene) scene.lookup("#sub-scene")).getRoot().lookup("#" + id);
    if (found == null) {
      throw new AssertionError("no node with the id " + id);
    }
    return found;
  }

  /** Runs an action on the JavaFX thread. */
  void change(Runnable what) {
    onFxThread(
        () -> {
          what.run();
          return true;
        });
    WindowFixture.settle();
  }

  /** Moves the first drone; visible at the next tick. */
  public void put(Pose pose, FlightPhase phase) {
    DroneSnapshot old = snapshot.drones().get(0);
    DroneState was = old.state();
    DroneState now =
        new DroneState(
            was.drone(),
            was.time(),
            Motion.restingAt(pose),
            phase,
            was.energy(),
            was.reference(),
            was.perception(),
            was.video());
    List<DroneSnapshot> drones = new ArrayList<>(snapshot.drones());
    drones.set(0, old.withState(now));
    SimTime time = snapshot.time();
    snapshot = new SimSnapshot(time, snapshot.clock(), snapshot.seed(), snapshot.arena(), drones);
  }

  /** Sets the active faults of the first drone; visible at the next tick. */
  void disturb(Fault... faults) {
    List<DroneSnapshot> drones = new ArrayList<>(snapshot.drones());
    DroneSnapshot old = drones.get(0);
    ActiveFaults acting = new ActiveFaults(LinkPreset.IDEAL, List.of(faults));
    drones.set(
        0,
        new DroneSnapshot(old.state(), old.link(), old.product(), old.start(), old.rgb(), acting));
    snapshot = snapshot.withDrones(drones);
  }

  /** Sets goals without an order; visible at the next tick. */
  void ask(Goal... goals) {
    List<OptionalDouble> none = Stream.of(goals).map(goal -> OptionalDouble.empty()).toList();
    Challenge challenge = new Challenge(List.of(goals), false, OptionalDouble.empty(), false);
    progress = new Progress(challenge, none, 0, Optional.empty());
  }

  /** Marks the first goal as reached; visible at the next tick. */
  void reachFirst() {
    List<OptionalDouble> reached = new ArrayList<>(progress.reached());
    reached.set(0, OptionalDouble.of(1));
    progress = new Progress(progress.challenge(), reached, 1, Optional.empty());
  }

  /** Sets the contacts; visible at the next tick. */
  void mark(ContactDecal... marks) {
    contacts = List.of(marks);
  }

  /** Changes the room's decor; visible at the next tick. */
  public void decorate(UnaryOperator<Decor> change) {
    furnish(arena -> arena.withDecor(change.apply(arena.decor())));
  }

  /** Changes the content of the room; visible at the next tick. */
  public void furnish(UnaryOperator<Arena> change) {
    snapshot =
        new SimSnapshot(
            snapshot.time(),
            snapshot.clock(),
            snapshot.seed(),
            change.apply(snapshot.arena()),
            snapshot.drones());
  }

  /** Advances the window's time and renders the result. */
  public void pass(double seconds) {
    nanos += Math.round(seconds * 1e9);
    onFxThread(
        () -> {
          ticker.tick(nanos);
          scene.applyCss();
          scene.layout();
          return true;
        });
  }

  /** Makes the camera follow the selected drone, from nearby. */
  void follow() {
    change(() -> scene.camera().followingProperty().set(true));
    settle();
  }

  /** Selects a view, and waits until the camera is there. */
  void look(RoomView view) {
    change(() -> scene.look(view));
    settle();
  }

  /** Waits until the camera rests. */
  void settle() {
    for (int i = 0; i < 20; i++) {
      pass(0.25);
    }
  }

  /** Renders the window with all cameras at rest. */
  Image settledPicture() {
    settle();
    return picture();
  }

  /** Renders the window without 3D support, with all cameras at rest. */
  Image softwarePicture() {
    settledPicture();
    waitUntil(
        () -> {
          nanos += 50_000_000;
          ticker.tick(nanos);
          return ((SoftwareSceneView) scene.view()).settled();
        });
    return picture();
  }

  /** Renders the window. */
  Image picture() {
    return onFxThread(() -> stage.getScene().snapshot(null));
  }

  /** Shows the inset and returns its next picture. */
  Image insetPicture() {
    ImageView inset = (ImageView) scene.lookup("#inset-picture");
    change(() -> scene.insetVisibleProperty().set(false));
    change(() -> scene.insetVisibleProperty().set(true));
    waitUntil(
        () -> {
          nanos += 1_000_000;
          ticker.tick(nanos);
          return inset.getImage() != null;
        });
    return inset.getImage();
  }

  /** Returns the mean brightness of a square around a pixel, 0 to 1. */
  static double brightness(Image picture, int x, int y, int half) {
    double sum = 0;
    for (int i = -half; i <= half; i++) {
      for (int j = -half; j <= half; j++) {
        sum += picture.getPixelReader().getColor(x + i, y + j).getBrightness();
      }
    }
    return sum / ((2 * half + 1) * (2 * half + 1));
  }

  /** The number of matching pixels, and their middle. */
  record GoalRegion(int count, double x, double y) {}

  /** Finds the pixels whose colour matches. */
  static GoalRegion find(Image picture, Predicate<Color> wanted) {
    int count = 0;
    double x = 0;
    double y = 0;
    for (int i = 0; i < (int) picture.getWidth(); i++) {
      for (int j = 0; j < (int) picture.getHeight(); j++) {
        if (wanted.test(picture.getPixelReader().getColor(i, j))) {
          count++;
          x += i;
          y += j;
        }
      }
    }
    return new GoalRegion(count, x / count, y / count);
  }
}
