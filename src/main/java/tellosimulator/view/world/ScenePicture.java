package tellosimulator.view.world;

import javafx.scene.Group;
import javafx.scene.Node;
import javafx.scene.PerspectiveCamera;
import javafx.scene.SceneAntialiasing;
import javafx.scene.SubScene;
import javafx.scene.transform.Affine;
import tellosimulator.math.Pose;
import tellosimulator.view.FxFrames;
import tellosimulator.view.FxSimulation;
import tellosimulator.view.ViewContext;

/**
 * The world in a SubScene, with the nodes of both cameras. Only where JavaFX has 3D. For the JavaFX
 * thread.
 */
final class ScenePicture implements WorldPicture {

  private final FxSimulation simulation;
  private final SimulatorCamera camera;
  private final DroneCamera droneCamera;
  private final World world;
  private final Group content = new Group();
  private final Group node = new Group();
  private final PerspectiveCamera orbiting = new PerspectiveCamera(true);
  private final PerspectiveCamera onDrone = new PerspectiveCamera(true);
  private final Affine orbitingPlace = new Affine();
  private final Affine onDronePlace = new Affine();
  private ViewCamera seen = ViewCamera.SIMULATOR;
  private SubScene subScene = new SubScene(new Group(), 0, 0);

  ScenePicture(ViewContext context, SimulatorCamera camera, DroneCamera droneCamera) {
    simulation = context.simulation();
    this.camera = camera;
    this.droneCamera = droneCamera;
    world = new World(simulation);
    orbiting.setFieldOfView(SimulatorCamera.FIELD_OF_VIEW_DEG);
    orbiting.getTransforms().add(orbitingPlace);
    equip();
    world.getChildren().addAll(orbiting, onDrone);
    content.getChildren().addAll(world.lights(), world);
    node.getChildren().add(subScene);
    node.setManaged(false);
    smoothEdges(false);
  }

  private void equip() {
    onDrone.setVerticalFieldOfView(false);
    onDrone.setFieldOfView(Math.toDegrees(droneCamera.optics().fieldOfView()));
    onDrone.setNearClip(droneCamera.optics().near());
    onDrone.getTransforms().add(onDronePlace);
  }

  @Override
  public Node node() {
    return node;
  }

  @Override
  public void resize(double width, double height) {
    subScene.setWidth(width);
    subScene.setHeight(height);
  }

  @Override
  public void showTrails(boolean shown) {
    world.trails().setVisible(shown);
  }

  /** A SubScene cannot change how it smooths edges, so there is a new one. */
  @Override
  public void smoothEdges(boolean smooth) {
    SubScene before = subScene;
    subScene.setRoot(new Group());
    subScene.setCamera(null); // a camera is only for one SubScene
    SceneAntialiasing edges = smooth ? SceneAntialiasing.BALANCED : SceneAntialiasing.DISABLED;
    subScene = new SubScene(content, before.getWidth(), before.getHeight(), true, edges);
    subScene.setId("sub-scene");
    subScene.setMouseTransparent(true);
    node.getChildren().set(0, subScene);
    lookThrough(seen);
  }

  @Override
  public void lookThrough(ViewCamera newSeen) {
    seen = newSeen;
    subScene.setCamera(seen == ViewCamera.DRONE ? onDrone : orbiting);
    show();
  }

  /** Shows what the camera through which one looks sees. */
  private void show() {
    if (seen == ViewCamera.DRONE) {
      world.showForDrone(simulation.selected().number());
    } else {
      world.showForPeople();
    }
  }

  @Override
  public void advance(long nanos) {
    FxFrames.aim(orbitingPlace, camera.pose());
    orbiting.setNearClip(camera.near());
    orbiting.setFarClip(camera.far());
    Pose onNose = droneCamera.pose();
    FxFrames.aim(onDronePlace, onNose);
    onDrone.setFarClip(droneCamera.far());
    show(); // another drone may be selected
    world.advance(nanos, seen == ViewCamera.DRONE ? onNose : camera.pose());
  }
}
