package tellosimulator.view.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.application.ConditionalFeature;
import javafx.application.Platform;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.beans.value.ObservableValue;
import javafx.css.PseudoClass;
import javafx.geometry.Bounds;
import javafx.geometry.Dimension2D;
import javafx.geometry.HPos;
import javafx.geometry.Insets;
import javafx.geometry.Rectangle2D;
import javafx.geometry.VPos;
import javafx.scene.AccessibleRole;
import javafx.scene.Node;
import javafx.scene.layout.Region;
import tellosimulator.goal.Goal;
import tellosimulator.math.Pose;
import tellosimulator.scenery.Scene;
import tellosimulator.scenery.SceneBuilder;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.orbit.RoomView;
import tellosimulator.scenery.overlay.Overlay;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.model.FxOverlayItems;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SceneContext;
import tellosimulator.view.model.UiTicker;
import tellosimulator.view.text.Messages;

/**
 * The room with its drones in 3D, seen through one of two cameras. The active faults, the wind, and
 * an inset with the picture of the drone's camera are shown over the scene. Without JavaFX 3D
 * support, the software camera renders the scene. Confined to the JavaFX thread.
 */
public final class Simulator3DScene extends Region {

  /** Margin between overlaid controls and the scene's edges [px]. */
  private static final double MARGIN = 12;

  /** Brightness of the room in the dark theme. Decided: by eye; colours remain distinguishable. */
  private static final double DIMMED = 0.78;

  private static final PseudoClass FROM_DRONE = PseudoClass.getPseudoClass("from-drone");

  private final ObjectProperty<ViewCamera> viewCamera =
      new SimpleObjectProperty<>(this, "viewCamera", ViewCamera.SIMULATOR);
  private final BooleanProperty trailVisible =
      new SimpleBooleanProperty(this, "trailVisible", true);
  private final BooleanProperty goalLineVisible =
      new SimpleBooleanProperty(this, "goalLineVisible", true);
  private final BooleanProperty dronesEnlarged =
      new SimpleBooleanProperty(this, "dronesEnlarged", true);
  private final BooleanProperty dimmed = new SimpleBooleanProperty(this, "dimmed");
  private final BooleanProperty antialiasing =
      new SimpleBooleanProperty(this, "antialiasing", true);
  private final SimulatorCamera camera;
  private final FxSimulation simulation;
  private final UiTicker ticker;
  private final DroneOptics optics;
  private final SceneBuilder scenes;

  /** A separate builder, because each builder caches the parts of its latest obstacles. */
  private final SceneBuilder ghostScenes = new SceneBuilder();

  private final Overlay overlay;
  private final FxOverlayItems marks;
  private final SceneView view;
  private final DroneCameraInset inset;
  private final WindArrow wind;
  private final FaultTags faults;
  private final GateNames gateNames = new GateNames();
  private final SelectionOutline selection;
  private final FrameRateMonitor frameRate = new FrameRateMonitor();
  private List<Region> covers = List.of();

  /** The focus ring, around the area between the covered edges. */
  private final Region ring = new Region();

  private Optional<GhostFlight> ghost = Optional.empty();

  public Simulator3DScene(SceneContext context) {
    simulation = context.simulation();
    ticker = context.ticker();
    optics = context.video().optics();
    scenes = context.video().scenes();
    marks = context.marks();
    overlay = new Overlay(simulation.snapshot());
    camera = new SimulatorCamera(simulation);
    view =
        Platform.isSupported(ConditionalFeature.SCENE3D)
            ? new SubSceneView()
            : new SoftwareSceneView();
    inset = new DroneCameraInset(context);
    wind = new WindArrow(context, camera);
    faults = new FaultTags(simulation.drones().size());
    selection = new SelectionOutline(simulation);
    initializeSelf(context);
    layoutParts();
    setupEventHandlers();
    setupBindings();
    context.ticker().onTick(this::advance);
  }

  /** Returns the camera that shows the room from outside. */
  public SimulatorCamera camera() {
    return camera;
  }

  /** The camera through which the scene is seen. */
  public ObjectProperty<ViewCamera> viewCameraProperty() {
    return viewCamera;
  }

  /** Switches to the simulator's camera and one of its views. */
  public void look(RoomView from) {
    viewCamera.set(ViewCamera.SIMULATOR);
    camera.look(from);
  }

  /** Switches to the simulator's camera and fits the whole scene. */
  public void fit() {
    viewCamera.set(ViewCamera.SIMULATOR);
    camera.fit();
  }

  /** Sets the goals that fitted views include. */
  public void setGoals(List<Goal> goals) {
    camera.setGoals(goals);
  }

  /** Sets the controls that cover the scene; fitted views avoid them. */
  public void setCovers(List<Region> newCovers) {
    covers = List.copyOf(newCovers);
  }

  /** Removes the trails. */
  public void clearTrails() {
    overlay.clearTrails();
  }

  /** Switches to the other of the two cameras. */
  public void switchCamera() {
    boolean drones = viewCamera.get() == ViewCamera.DRONE;
    viewCamera.set(drones ? ViewCamera.SIMULATOR : ViewCamera.DRONE);
  }

  /** Whether trails are shown. */
  public BooleanProperty trailVisibleProperty() {
    return trailVisible;
  }

  /** Whether a line leads from each drone to its next goal. */
  public BooleanProperty goalLineVisibleProperty() {
    return goalLineVisible;
  }

  /** Whether drones that would look small are drawn enlarged. */
  public BooleanProperty dronesEnlargedProperty() {
    return dronesEnlarged;
  }

  /** Whether the room is dimmed for the dark theme. The video of the drones is never dimmed. */
  public BooleanProperty dimmedProperty() {
    return dimmed;
  }

  /** Whether the inset shows the drone's camera. */
  public BooleanProperty insetVisibleProperty() {
    return inset.shownProperty();
  }

  /** Shows the inset and its buttons only while the value is true. */
  public void showInsetWhile(ObservableValue<Boolean> wanted) {
    inset.visibleProperty().bind(wanted);
  }

  /** Whether the inset is enlarged. */
  public BooleanProperty insetEnlargedProperty() {
    return inset.enlargedProperty();
  }

  /**
   * Whether edges are anti-aliased. Anti-aliasing is switched off automatically if the frame rate
   * becomes too low, for example without a graphics card. It then stays off until the property
   * changes.
   */
  public BooleanProperty antialiasingProperty() {
    return antialiasing;
  }

  /** Shows another flight together with this one; empty removes it. */
  public void setGhost(Optional<GhostFlight> newGhost) {
    ghost.ifPresent(before -> getChildren().remove(before.labels()));
    ghost = newGhost;
    ghost.ifPresent(now -> getChildren().add(getChildren().indexOf(faults), now.labels()));
    requestLayout();
  }

  /** Redraws the trails from earlier snapshots. */
  public void retrace(Iterable<SimSnapshot> past) {
    overlay.clearTrails();
    past.forEach(each -> overlay.advance(each, 0));
  }

  /** Returns the view that renders the scene. */
  SceneView view() {
    return view;
  }

  /** Stops the video and the rendering. */
  public void rest() {
    inset.rest();
    view.rest();
  }

  private void initializeSelf(SceneContext context) {
    setId("scene-3d");
    getStyleClass().add("scene-3d");
    getStylesheets().add(Simulator3DScene.class.getResource("world.css").toExternalForm());
    setMinSize(0, 0);
    setFocusTraversable(true);
    setAccessibleRole(AccessibleRole.IMAGE_VIEW);
    Messages messages = context.language().messages(Simulator3DScene.class);
    accessibleTextProperty().bind(messages.text("scene"));
    accessibleHelpProperty().bind(messages.text("scene.help"));
    ring.getStyleClass().add("ring");
    ring.setMouseTransparent(true);
    ring.setManaged(false);
  }

  private void layoutParts() {
    getChildren().addAll(view.node(), gateNames, faults, selection, wind, inset, ring);
  }

  private void setupEventHandlers() {
    CameraGestures.install(this, camera);
  }

  private void setupBindings() {
    trailVisible.subscribe(overlay::showTrails);
    goalLineVisible.subscribe(overlay::showGoalLine);
    antialiasing.subscribe(this::smoothEdges);
    viewCamera.subscribe(this::showFrame);
    selection.stillProperty().bind(camera.reducedMotionProperty());
  }

  /**
   * Styles the border around the picture of the drone's camera. The picture may be smaller than the
   * region.
   */
  private void showFrame(ViewCamera chosen) {
    pseudoClassStateChanged(FROM_DRONE, chosen == ViewCamera.DRONE);
    requestLayout();
  }

  private void smoothEdges(boolean smooth) {
    frameRate.restart();
    view.smoothEdges(smooth);
  }

  private void monitorFrameRate(long nanos) {
    boolean before = frameRate.jerky();
    frameRate.frame(nanos);
    if (frameRate.jerky() && !before) {
      view.smoothEdges(false);
    }
  }

  private void advance(long nanos) {
    monitorFrameRate(nanos);
    camera.advance(nanos, pictureArea());
    showScene(nanos);
    selection.advance(nanos, viewCamera.get() == ViewCamera.SIMULATOR, camera.viewpoint());
    if (camera.glides() || selection.isVisible()) {
      ticker.wake();
    }
    inset.advance(nanos);
    wind.advance(viewCamera.get() == ViewCamera.SIMULATOR);
  }

  private PictureArea pictureArea() {
    List<Rectangle2D> covered = new ArrayList<>();
    covers.stream().filter(this::covers).map(this::place).forEach(covered::add);
    if (inset.isVisible() && inset.shownProperty().get()) {
      covered.add(place(inset));
    }
    covered.removeIf(part -> part.getWidth() == 0 || part.getHeight() == 0);
    return new PictureArea(new Dimension2D(getWidth(), getHeight()), getInsets(), covered);
  }

  private boolean covers(Node cover) {
    boolean shown = cover.getScene() == getScene();
    for (Node node = cover; node != null; node = node.getParent()) {
      shown &= node.isVisible();
    }
    return shown;
  }

  /** Returns the bounds of a node in this region. */
  private Rectangle2D place(Node node) {
    Bounds bounds = sceneToLocal(node.localToScene(node.getLayoutBounds()));
    return new Rectangle2D(
        bounds.getMinX(), bounds.getMinY(), bounds.getWidth(), bounds.getHeight());
  }

  private void showScene(long nanos) {
    SimSnapshot snapshot = simulation.pictured();
    overlay.advance(snapshot, nanos);
    boolean fromDrone = viewCamera.get() == ViewCamera.DRONE;
    view.dim(dimmed.get() && !fromDrone ? DIMMED : 1);
    if (fromDrone) {
      view.show(scenes.scene(snapshot, simulation.selected().number()), onDrone(), nanos);
      faults.advance(snapshot, Optional.empty());
      gateNames.advance(List.of(), Optional.empty());
      ghost.ifPresent(GhostFlight::hideLabels);
    } else {
      Viewpoint viewpoint = camera.viewpoint();
      view.show(
          forPeople(scenes, snapshot, viewpoint).withOverlay(aids(snapshot, viewpoint, nanos)),
          viewpoint,
          nanos);
      faults.advance(snapshot, Optional.of(viewpoint));
      gateNames.advance(marks.goals(snapshot.arena()), Optional.of(viewpoint));
      ghost.ifPresent(other -> other.label(viewpoint));
    }
  }

  private Scene forPeople(SceneBuilder builder, SimSnapshot snapshot, Viewpoint viewpoint) {
    return dronesEnlarged.get()
        ? builder.scene(snapshot, viewpoint.pose().position())
        : builder.scene(snapshot);
  }

  /** Returns the visual aids: instances that no drone's camera sees. */
  private List<Instance> aids(SimSnapshot snapshot, Viewpoint viewpoint, long nanos) {
    List<Instance> aids = new ArrayList<>();
    ghost.ifPresent(
        other -> {
          other.showTrails(trailVisible.get());
          Scene scene = forPeople(ghostScenes, other.snapshot(), viewpoint);
          aids.addAll(other.instances(scene, viewpoint, nanos));
        });
    overlay.choose(simulation.selected().number());
    overlay.show(marks.goals(snapshot.arena()), marks.contacts());
    aids.addAll(overlay.instances(snapshot, viewpoint.eye()));
    return aids;
  }

  /** Returns the viewpoint of the selected drone's nose camera. */
  private Viewpoint onDrone() {
    Pose nose = optics.nose(simulation.selected().poseProperty().get());
    return new Viewpoint(
        nose, optics.fieldOfView(), false, optics.near(), 1 + camera.roomDiagonal());
  }

  @Override
  protected void layoutChildren() {
    layOutView();
    layOut(inset, HPos.RIGHT, VPos.TOP);
    layOut(wind, HPos.LEFT, VPos.BOTTOM);
    Insets covered = getInsets();
    ring.resizeRelocate(
        covered.getLeft(),
        covered.getTop(),
        getWidth() - covered.getLeft() - covered.getRight(),
        getHeight() - covered.getTop() - covered.getBottom());
  }

  /**
   * Lays out a control in a corner of the uncovered area. The insets of this region are the widths
   * of the controls along its edges; the scene continues behind these controls.
   */
  private void layOut(Node corner, HPos across, VPos down) {
    Insets covered = getInsets();
    double left = covered.getLeft() + MARGIN;
    double top = covered.getTop() + MARGIN;
    double width = getWidth() - left - covered.getRight() - MARGIN;
    double height = getHeight() - top - covered.getBottom() - MARGIN;
    layoutInArea(corner, left, top, width, height, 0, across, down);
  }

  /**
   * Sizes the view. The picture of the drone's camera keeps its aspect ratio; the picture of the
   * simulator's camera fills the region.
   */
  private void layOutView() {
    double ratio = (double) DroneOptics.WIDTH / DroneOptics.HEIGHT;
    boolean onDrone = viewCamera.get() == ViewCamera.DRONE;
    double width = onDrone ? Math.min(getWidth(), getHeight() * ratio) : getWidth();
    double height = onDrone ? width / ratio : getHeight();
    view.resize(width, height);
    faults.resizeRelocate(0, 0, getWidth(), getHeight());
    gateNames.resizeRelocate(0, 0, getWidth(), getHeight());
    selection.resizeRelocate(0, 0, getWidth(), getHeight());
    ghost.ifPresent(other -> other.labels().resizeRelocate(0, 0, getWidth(), getHeight()));
    view.node().relocate((getWidth() - width) / 2, (getHeight() - height) / 2);
  }
}
