package tellosimulator.view.world;

import javafx.application.ConditionalFeature;
import javafx.application.Platform;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.geometry.HPos;
import javafx.geometry.VPos;
import javafx.scene.Node;
import javafx.scene.layout.Region;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.ViewContext;

/**
 * The room with its drones in 3D, seen through one of two cameras; over it the inset with the
 * drone's camera and where the wind blows. Where JavaFX has no 3D, the software camera draws it.
 * For the JavaFX thread.
 */
public final class Simulator3DScene extends Region {

  /** Between what lies in a corner and the scene's edges [px]. */
  private static final double MARGIN = 12;

  private final ObjectProperty<ViewCamera> viewCamera =
      new SimpleObjectProperty<>(this, "viewCamera", ViewCamera.SIMULATOR);
  private final BooleanProperty trailVisible =
      new SimpleBooleanProperty(this, "trailVisible", true);
  private final BooleanProperty antialiasing = new SimpleBooleanProperty(this, "antialiasing");
  private final SimulatorCamera camera;
  private final WorldPicture picture;
  private final DroneCameraInset inset;
  private final WindArrow wind;

  public Simulator3DScene(ViewContext context) {
    camera = new SimulatorCamera(context.simulation());
    DroneCamera onDrone = new DroneCamera(context.simulation(), context.video().optics());
    picture =
        Platform.isSupported(ConditionalFeature.SCENE3D)
            ? new ScenePicture(context, camera, onDrone)
            : new DrawnPicture(context, camera, onDrone);
    inset = new DroneCameraInset(context);
    wind = new WindArrow(context, camera);
    initializeSelf();
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

  /** What it shows of the world. */
  WorldPicture picture() {
    return picture;
  }

  /** Looks at no more video, and takes part in none. */
  public void rest() {
    inset.rest();
    picture.rest();
  }

  private void initializeSelf() {
    setId("scene-3d");
    getStyleClass().add("scene-3d");
    getStylesheets().add(Simulator3DScene.class.getResource("world.css").toExternalForm());
    setMinSize(0, 0);
    setFocusTraversable(false);
  }

  private void layoutParts() {
    getChildren().addAll(picture.node(), wind, inset);
  }

  private void setupEventHandlers() {
    CameraGestures.install(this, camera);
  }

  private void setupBindings() {
    trailVisible.subscribe(picture::showTrails);
    antialiasing.subscribe(picture::smoothEdges);
    viewCamera.subscribe(
        seen -> {
          picture.lookThrough(seen);
          requestLayout();
        });
  }

  private void advance(long nanos) {
    camera.advance(nanos);
    picture.advance(nanos);
    inset.advance(nanos);
    wind.advance(viewCamera.get() == ViewCamera.SIMULATOR);
  }

  @Override
  protected void layoutChildren() {
    layOutPicture();
    layOut(inset, HPos.RIGHT, VPos.TOP);
    layOut(wind, HPos.LEFT, VPos.BOTTOM);
  }

  private void layOut(Node corner, HPos across, VPos down) {
    double width = getWidth() - 2 * MARGIN;
    layoutInArea(corner, MARGIN, MARGIN, width, getHeight() - 2 * MARGIN, 0, across, down);
  }

  /** The picture of the drone's camera keeps its form; the other fills everything. */
  private void layOutPicture() {
    double ratio = (double) DroneOptics.WIDTH / DroneOptics.HEIGHT;
    boolean drones = viewCamera.get() == ViewCamera.DRONE;
    double width = drones ? Math.min(getWidth(), getHeight() * ratio) : getWidth();
    double height = drones ? width / ratio : getHeight();
    picture.resize(width, height);
    picture.node().relocate((getWidth() - width) / 2, (getHeight() - height) / 2);
  }
}
