package tellosimulator.view.world;

import java.util.Optional;
import javafx.application.ConditionalFeature;
import javafx.application.Platform;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.geometry.HPos;
import javafx.geometry.VPos;
import javafx.scene.SubScene;
import javafx.scene.control.Label;
import javafx.scene.layout.Region;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.ViewContext;
import tellosimulator.view.text.Messages;
import tellosimulator.view.video.WindowVideo;

/**
 * The room with its drones in 3D, seen through one of two cameras; over it the inset with the
 * drone's camera. Where JavaFX has no 3D it says so in one sentence. For the JavaFX thread.
 */
public final class Simulator3DScene extends Region {

  private final Messages messages;
  private final WindowVideo video;
  private final ObjectProperty<ViewCamera> viewCamera =
      new SimpleObjectProperty<>(this, "viewCamera", ViewCamera.SIMULATOR);
  private final BooleanProperty trailVisible =
      new SimpleBooleanProperty(this, "trailVisible", true);
  private final BooleanProperty antialiasing = new SimpleBooleanProperty(this, "antialiasing");
  private final SimulatorCamera camera;
  private final DroneCamera droneCamera;
  private final Optional<ScenePicture> picture;
  private final DroneCameraInset inset;
  private final Label noThreeD = new Label();

  public Simulator3DScene(ViewContext context) {
    video = context.video();
    messages = context.language().messages(Simulator3DScene.class);
    camera = new SimulatorCamera(context.simulation());
    droneCamera = new DroneCamera(context.simulation(), context.video().optics());
    picture =
        Platform.isSupported(ConditionalFeature.SCENE3D)
            ? Optional.of(new ScenePicture(context.simulation(), camera, droneCamera))
            : Optional.empty();
    inset = new DroneCameraInset(context);
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

  /** Looks at no more video, and takes part in none. */
  public void rest() {
    inset.rest();
    video.photographNoMore();
  }

  private void initializeSelf() {
    setId("scene-3d");
    getStyleClass().add("scene-3d");
    getStylesheets().add(Simulator3DScene.class.getResource("world.css").toExternalForm());
    setMinSize(0, 0);
    setFocusTraversable(false);
  }

  private void initializeParts() {
    noThreeD.setId("no-3d");
    noThreeD.setWrapText(true);
    noThreeD.setVisible(picture.isEmpty());
  }

  private void layoutParts() {
    getChildren().addAll(noThreeD, inset);
    picture.ifPresent(
        shown -> {
          getChildren().add(0, shown.node());
          // snapshots are lit by the lights of the window's scene, not by those of the SubScene
          getChildren().add(shown.world().lights());
        });
  }

  private void setupEventHandlers() {
    CameraGestures.install(this, camera);
  }

  private void setupBindings() {
    noThreeD.textProperty().bind(messages.text("no-3d"));
    picture.ifPresent(this::bind);
  }

  private void bind(ScenePicture shown) {
    video.photographBy(shown::photograph);
    shown.world().trails().visibleProperty().bind(trailVisible);
    antialiasing.addListener(
        (property, before, smooth) -> {
          shown.build(smooth);
          getChildren().set(0, shown.node());
          requestLayout(); // nobody asks for it when a child comes that is not managed
        });
    viewCamera.addListener(
        (property, before, seen) -> {
          shown.lookThrough(seen);
          requestLayout();
        });
  }

  private void advance(long nanos) {
    camera.advance(nanos);
    picture.ifPresent(shown -> shown.advance(nanos));
    inset.advance(nanos);
  }

  @Override
  protected void layoutChildren() {
    double width = getWidth();
    double height = getHeight();
    picture.ifPresent(this::layOut);
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

  /** The picture of the drone's camera keeps its form; the other fills everything. */
  private void layOut(ScenePicture shown) {
    double ratio = (double) DroneOptics.WIDTH / DroneOptics.HEIGHT;
    boolean drones = viewCamera.get() == ViewCamera.DRONE;
    double width = drones ? Math.min(getWidth(), getHeight() * ratio) : getWidth();
    double height = drones ? width / ratio : getHeight();
    SubScene node = shown.node();
    node.setWidth(width);
    node.setHeight(height);
    node.relocate((getWidth() - width) / 2, (getHeight() - height) / 2);
  }
}
