package tellosimulator.view.world;

import javafx.scene.Group;
import javafx.scene.Node;
import javafx.scene.PerspectiveCamera;
import javafx.scene.SceneAntialiasing;
import javafx.scene.SubScene;
import javafx.scene.transform.Affine;
import tellosimulator.math.Pose;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.FxFrames;
import tellosimulator.view.FxSimulation;

/**
 * The world in a SubScene, with the nodes of both cameras. Only where JavaFX has 3D. For the JavaFX
 * thread.
 */
final class ScenePicture {

  private final SimulatorCamera camera;
  private final DroneCamera droneCamera;
  private final World world;
  private final Group content = new Group();
  private final PerspectiveCamera orbiting = new PerspectiveCamera(true);
  private final PerspectiveCamera onDrone = new PerspectiveCamera(true);
  private final Affine orbitingPlace = new Affine();
  private final Affine onDronePlace = new Affine();
  private ViewCamera seen = ViewCamera.SIMULATOR;
  private SubScene subScene = new SubScene(new Group(), 0, 0);

  ScenePicture(FxSimulation simulation, SimulatorCamera camera, DroneCamera droneCamera) {
    this.camera = camera;
    this.droneCamera = droneCamera;
    world = new World(simulation);
    orbiting.setFieldOfView(SimulatorCamera.FIELD_OF_VIEW_DEG);
    orbiting.getTransforms().add(orbitingPlace);
    onDrone.setVerticalFieldOfView(false);
    onDrone.setFieldOfView(Math.toDegrees(droneCamera.optics().fieldOfView()));
    onDrone.setNearClip(DroneOptics.NEAR);
    onDrone.getTransforms().add(onDronePlace);
    world.getChildren().addAll(orbiting, onDrone);
    content.getChildren().addAll(world.lights(), world);
    build(false);
  }

  World world() {
    return world;
  }

  SubScene node() {
    return subScene;
  }

  /** A SubScene cannot change how it smooths edges, so there is a new one. */
  void build(boolean smooth) {
    subScene.setRoot(new Group());
    subScene.setCamera(null); // a camera is only for one SubScene
    SceneAntialiasing edges = smooth ? SceneAntialiasing.BALANCED : SceneAntialiasing.DISABLED;
    subScene = new SubScene(content, 0, 0, true, edges);
    subScene.setId("sub-scene");
    subScene.setManaged(false);
    subScene.setMouseTransparent(true);
    lookThrough(seen);
  }

  void lookThrough(ViewCamera newSeen) {
    seen = newSeen;
    subScene.setCamera(seen == ViewCamera.DRONE ? onDrone : orbiting);
    world.showFor(seen);
  }

  /**
   * Moves on what is in the picture.
   *
   * @param nanos the time of the picture [ns]
   */
  void advance(long nanos) {
    FxFrames.aim(orbitingPlace, camera.pose());
    orbiting.setNearClip(camera.near());
    orbiting.setFarClip(camera.far());
    Pose onNose = droneCamera.pose();
    FxFrames.aim(onDronePlace, onNose);
    onDrone.setFarClip(droneCamera.far());
    world.showFor(seen); // another drone may be selected
    world.advance(nanos, seen == ViewCamera.DRONE ? onNose : camera.pose());
  }

  /**
   * Takes a picture with the drone's camera: of what is in the room, without what only helps
   * people.
   *
   * @param photographer takes it of a node and with a camera
   */
  void photograph(Photographer photographer) {
    world.showFor(ViewCamera.DRONE);
    photographer.photograph(world, onDrone);
    world.showFor(seen);
  }

  /** Takes a picture. */
  @FunctionalInterface
  interface Photographer {
    void photograph(Node room, PerspectiveCamera camera);
  }
}
