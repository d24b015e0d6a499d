package tellosimulator.view.world;

import javafx.scene.Node;
import tellosimulator.scenery.Scene;

/** A view that renders scenes in the window. Confined to the JavaFX thread. */
sealed interface SceneView permits SubSceneView, SoftwareSceneView {

  /**
   * Returns the node that shows the scene. Its size is set by {@link #resize}, not by the layout.
   */
  Node node();

  /** Sets the size of the view [px]. */
  void resize(double width, double height);

  /** Switches anti-aliasing on or off, where supported. */
  void smoothEdges(boolean smooth);

  /**
   * Dims the lights in the room. Luminous parts and visual aids may keep their brightness.
   *
   * @param brightness the new brightness, 0 to 1
   */
  void dim(double brightness);

  /**
   * Shows a scene.
   *
   * @param nanos the time of the frame [ns]
   */
  void show(Scene scene, Viewpoint viewpoint, long nanos);

  /** Stops the view's threads, if there are any. */
  default void rest() {}
}
