package tellosimulator.view.world;

import javafx.scene.Node;
import tellosimulator.scenery.Scene;

/** Shows scenes in the window. For the JavaFX thread. */
sealed interface SceneView permits SubSceneView, SoftwareSceneView {

  /** What is to be seen; it takes no part in layout. */
  Node node();

  /** Sets its size [px]. */
  void resize(double width, double height);

  /** Smooths edges, where that is possible. */
  void smoothEdges(boolean smooth);

  /**
   * Dims the lights in the room; what shines, and aids for people, may stay as they are.
   *
   * @param brightness 0 to 1
   */
  void dim(double brightness);

  /**
   * Shows a scene.
   *
   * @param nanos the time of the frame [ns]
   */
  void show(Scene scene, Viewpoint viewpoint, long nanos);

  /** Ends its threads, if it has any. */
  default void rest() {}
}
