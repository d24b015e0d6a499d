package tellosimulator.view.world;

import javafx.scene.Node;
import javafx.scene.image.ImageView;
import javafx.stage.Window;
import tellosimulator.scenery.Scene;
import tellosimulator.view.fx.ScreenPixels;

/**
 * Shows scenes when JavaFX has no 3D support. The software camera renders them on a separate
 * thread: at most 25 frames a second, and none while nothing changes. Confined to the JavaFX
 * thread.
 */
final class SoftwareSceneView implements SceneView {

  /**
   * Minimum time between two frames [ns]. Decided: 25 frames a second leave processor time for
   * everything else.
   */
  private static final long PERIOD = 40_000_000;

  /**
   * Maximum number of pixels. Measured: a million pixels take one core about 14 ms. A larger frame
   * is rendered at a lower resolution and stretched.
   */
  private static final double MOST_PIXELS = 1e6;

  private final BackgroundRenderer renderer = new BackgroundRenderer();
  private final ImageView node = new ImageView();
  private final ScreenPixels pixels = new ScreenPixels(node);
  private long lastNanos = Long.MIN_VALUE;

  SoftwareSceneView() {
    node.setId("software-scene");
    node.setManaged(false);
    node.setMouseTransparent(true);
  }

  @Override
  public Node node() {
    return node;
  }

  @Override
  public void resize(double width, double height) {
    node.setFitWidth(width);
    node.setFitHeight(height);
  }

  /** Does nothing, because several samples per pixel would take too long. */
  @Override
  public void smoothEdges(boolean smooth) {}

  /** Dims everything: the single image becomes translucent in front of a dark background. */
  @Override
  public void dim(double brightness) {
    node.setOpacity(brightness);
  }

  @Override
  public void show(Scene scene, Viewpoint viewpoint, long nanos) {
    renderer
        .take()
        .ifPresent(
            frame ->
                pixels.show(
                    frame.width(),
                    frame.height(),
                    argb -> System.arraycopy(frame.argb(), 0, argb, 0, argb.length)));
    boolean due = lastNanos == Long.MIN_VALUE || nanos - lastNanos >= PERIOD;
    if (due && !renderer.busy() && node.getFitWidth() >= 1 && node.getFitHeight() >= 1) {
      lastNanos = nanos;
      double area = node.getFitWidth() * node.getFitHeight();
      double scale = Math.min(outputScale(), Math.sqrt(MOST_PIXELS / area));
      int width = (int) Math.max(1, Math.round(scale * node.getFitWidth()));
      int height = (int) Math.max(1, Math.round(scale * node.getFitHeight()));
      renderer.render(scene, viewpoint.pinhole(width, height));
    }
  }

  private double outputScale() {
    Window window = node.getScene() == null ? null : node.getScene().getWindow();
    return window == null ? 1 : window.getOutputScaleX();
  }

  /** Returns whether there is nothing new to show. */
  boolean settled() {
    return renderer.settled();
  }

  @Override
  public void rest() {
    renderer.close();
  }
}
