package tellosimulator.view.world;

import javafx.scene.Node;

/** What the window shows of the world, through one of two cameras. For the JavaFX thread. */
sealed interface WorldPicture permits ScenePicture, DrawnPicture {

  /** What is to be seen; it does not care about layouts. */
  Node node();

  /** How large it is [px]. */
  void resize(double width, double height);

  /** Sees the world through another camera. */
  void lookThrough(ViewCamera camera);

  /** Shows the flown paths, or does not. */
  void showTrails(boolean shown);

  /** Makes edges smooth, where that is possible. */
  void smoothEdges(boolean smooth);

  /**
   * Moves on with the drones.
   *
   * @param nanos the time of the frame [ns]
   */
  void advance(long nanos);

  /** Ends what it does beside showing. */
  default void rest() {}
}
