package tellosimulator.view.world;

import javafx.scene.Group;
import javafx.scene.Node;
import javafx.scene.PerspectiveCamera;
import javafx.scene.SceneAntialiasing;
import javafx.scene.SubScene;
import javafx.scene.transform.Affine;
import tellosimulator.scenery.Scene;
import tellosimulator.view.fx.FxFrames;

/**
 * Shows scenes in a {@link SubScene}, which requires JavaFX 3D support. Confined to the JavaFX
 * thread.
 */
final class SubSceneView implements SceneView {

  private final SceneNodes nodes = new SceneNodes();
  private final Group content = new Group(nodes);
  private final Group node = new Group();
  private final PerspectiveCamera camera = new PerspectiveCamera(true);
  private final Affine cameraPose = new Affine();
  private SubScene subScene = new SubScene(new Group(), 0, 0);

  SubSceneView() {
    camera.getTransforms().add(cameraPose);
    nodes.getChildren().add(camera);
    node.getChildren().add(subScene);
    node.setManaged(false);
    smoothEdges(false);
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

  /** Replaces the SubScene, because the anti-aliasing of a SubScene cannot be changed. */
  @Override
  public void smoothEdges(boolean smooth) {
    SubScene before = subScene;
    subScene.setRoot(new Group());
    subScene.setCamera(null); // a camera can belong to one SubScene only
    SceneAntialiasing edges = smooth ? SceneAntialiasing.BALANCED : SceneAntialiasing.DISABLED;
    subScene = new SubScene(content, before.getWidth(), before.getHeight(), true, edges);
    subScene.setId("sub-scene");
    subScene.setMouseTransparent(true);
    subScene.setCamera(camera);
    node.getChildren().set(0, subScene);
  }

  @Override
  public void dim(double brightness) {
    nodes.dim(brightness);
  }

  @Override
  public void show(Scene scene, Viewpoint viewpoint, long nanos) {
    FxFrames.aim(cameraPose, viewpoint.pose());
    camera.setVerticalFieldOfView(viewpoint.vertical());
    camera.setFieldOfView(Math.toDegrees(viewpoint.fieldOfView()));
    camera.setNearClip(viewpoint.near());
    camera.setFarClip(viewpoint.far());
    nodes.show(scene, viewpoint.pose());
  }
}
