package tellosimulator.view.world;

import javafx.geometry.Rectangle2D;
import javafx.scene.Camera;
import javafx.scene.Node;
import javafx.scene.SnapshotParameters;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;
import javafx.scene.paint.Color;
import tellosimulator.view.video.SnapshotOrder;

/** A picture that is taken of a node in 3D, again and again. For the JavaFX thread. */
final class Photograph {

  private final SnapshotParameters parameters = new SnapshotParameters();
  private WritableImage taken;

  Photograph() {
    parameters.setFill(Color.BLACK);
  }

  /**
   * Takes a picture, of the size and into the pixels that were ordered.
   *
   * @param camera must be in the scene too
   */
  void take(Node node, Camera camera, SnapshotOrder order) {
    int width = order.width();
    int height = order.height();
    if (taken == null || taken.getWidth() != width || taken.getHeight() != height) {
      taken = new WritableImage(width, height);
    }
    parameters.setViewport(new Rectangle2D(0, 0, width, height));
    parameters.setCamera(camera);
    parameters.setDepthBuffer(true); // not before: where there is no 3D, JavaFX warns of it
    taken = node.snapshot(parameters, taken);
    taken
        .getPixelReader()
        .getPixels(
            0, 0, width, height, PixelFormat.getIntArgbPreInstance(), order.argb(), 0, width);
  }
}
