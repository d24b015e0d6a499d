package tellosimulator.view.world;

import javafx.application.ConditionalFeature;
import javafx.application.Platform;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.geometry.HPos;
import javafx.geometry.VPos;
import javafx.scene.Group;
import javafx.scene.SceneAntialiasing;
import javafx.scene.SubScene;
import javafx.scene.control.Label;
import javafx.scene.layout.Region;
import tellosimulator.math.Pose;
import tellosimulator.view.FxSimulation;
import tellosimulator.view.ViewContext;
import tellosimulator.view.text.Messages;

/**
 * The room with its drones in 3D, seen through one of two cameras; over it the inset with the
 * drone's camera. Where JavaFX has no 3D it says so in one sentence. For the JavaFX thread.
 */
public final class Simulator3DScene extends Region {

  private final FxSimulation simulation;
  private final Messages messages;
  private final boolean supported = Platform.isSupported(ConditionalFeature.SCENE3D);
  private final ObjectProperty<ViewCamera> viewCamera =
      new SimpleObjectProperty<>(this, "viewCamera", ViewCamera.SIMULATOR);
  private final BooleanProperty trailVisible =
      new SimpleBooleanProperty(this, "trailVisible", true);
  private final BooleanProperty antialiasing = new SimpleBooleanProperty(this, "antialiasing");
  private final World world;
  private final SimulatorCamera camera;
  private final DroneCamera droneCamera;
  private final DroneCameraInset inset;
  private final Group content = new Group();
  private final Label noThreeD = new Label();
  private SubScene subScene = new SubScene(new Group(), 0, 0);

  public Simulator3DScene(ViewContext context) {
    simulation = context.simulation();
    messages = context.language().messages(Simulator3DScene.class);
    world = new World(simulation);
    camera = new SimulatorCamera(simulation);
    droneCamera = new DroneCamera(simulation);
    inset = new DroneCameraInset(messages);
    initializeSelf();
    initializeParts();
    layoutParts();
    setupEventHandlers();
    setupBindings();
    context.pulse().onBeat(this::advance);
  }

  /** The camera that orbits the selected drone. */
  public SimulatorCamera camera() {
    return camera;
  }

  /** Through which camera one sees the scene. */
  public ObjectProperty<ViewCamera> viewCameraProperty() {
    return viewCamera;
  }

  /** Whether the flown paths are shown. */
  public BooleanProperty trailVisibleProperty() {
    return trailVisible;
  }

  /** Whether the inset shows the picture of the drone's camera. */
  public BooleanProperty insetVisibleProperty() {
    return inset.shownProperty();
  }

  /** Whether the inset is large. */
  public BooleanProperty insetEnlargedProperty() {
    return inset.enlargedProperty();
  }

  /** Whether edges are smooth, which costs time without a graphics card. */
  public BooleanProperty antialiasingProperty() {
    return antialiasing;
  }

  /** Forgets the flown paths. */
  public void clearTrails() {
    world.clearTrails();
  }

  private void initializeSelf() {
    setId("scene-3d");
    getStyleClass().add("scene-3d");
    getStylesheets().add(Simulator3DScene.class.getResource("world.css").toExternalForm());
    setMinSize(0, 0);
    setFocusTraversable(false);
  }

  private void initializeParts() {
    world.getChildren().addAll(camera.node(), droneCamera.node());
    content.getChildren().addAll(world.lights(), world);
    noThreeD.setId("no-3d");
    noThreeD.setWrapText(true);
    noThreeD.setVisible(!supported);
    inset.setVisible(supported);
  }

  private void layoutParts() {
    // snapshots are lit by the lights of the window's scene, not by those of the SubScene
    getChildren().addAll(subScene, noThreeD, inset, world.lights());
  }

  private void setupEventHandlers() {
    CameraGestures.install(this, camera);
  }

  private void setupBindings() {
    noThreeD.textProperty().bind(messages.text("no-3d"));
    world.trails().visibleProperty().bind(trailVisible);
    antialiasing.subscribe(this::buildSubScene);
    viewCamera.subscribe(this::lookThrough);
  }

  /** A SubScene cannot change how it smooths edges, so there is a new one. */
  private void buildSubScene(boolean smooth) {
    subScene.setRoot(new Group());
    SceneAntialiasing edges = smooth ? SceneAntialiasing.BALANCED : SceneAntialiasing.DISABLED;
    subScene = new SubScene(supported ? content : new Group(), 0, 0, true, edges);
    subScene.setId("sub-scene");
    subScene.setManaged(false);
    subScene.setMouseTransparent(true);
    getChildren().set(0, subScene);
    lookThrough(viewCamera.get());
  }

  private void lookThrough(ViewCamera seen) {
    boolean drones = seen == ViewCamera.DRONE;
    subScene.setCamera(drones ? droneCamera.node() : camera.node());
    world.aids().setVisible(!drones);
    requestLayout();
  }

  private void advance(long nanos) {
    camera.advance(nanos);
    droneCamera.advance();
    Pose eye = viewCamera.get() == ViewCamera.DRONE ? droneCamera.pose() : camera.pose();
    world.advance(nanos, eye);
    if (supported) {
      inset.advance(nanos, world, droneCamera);
    }
  }

  @Override
  protected void layoutChildren() {
    double width = getWidth();
    double height = getHeight();
    double shownWidth = width;
    double shownHeight = height;
    if (viewCamera.get() == ViewCamera.DRONE) {
      double ratio = (double) DroneCamera.WIDTH / DroneCamera.HEIGHT;
      shownWidth = Math.min(width, height * ratio);
      shownHeight = shownWidth / ratio;
    }
    subScene.setWidth(shownWidth);
    subScene.setHeight(shownHeight);
    subScene.relocate((width - shownWidth) / 2, (height - shownHeight) / 2);
    double margin = 12;
    layoutInArea(
        noThreeD,
        margin,
        margin,
        width - 2 * margin,
        height - 2 * margin,
        0,
        HPos.CENTER,
        VPos.CENTER);
    layoutInArea(
        inset, margin, margin, width - 2 * margin, height - 2 * margin, 0, HPos.RIGHT, VPos.TOP);
  }
}
