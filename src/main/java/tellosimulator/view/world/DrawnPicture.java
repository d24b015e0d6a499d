package tellosimulator.view.world;

import java.util.List;
import java.util.OptionalInt;
import javafx.scene.Node;
import javafx.scene.image.ImageView;
import tellosimulator.math.Pose;
import tellosimulator.video.camera.CameraIntrinsics;
import tellosimulator.video.camera.PinholeCamera;
import tellosimulator.view.FxSimulation;
import tellosimulator.view.ScreenPixels;
import tellosimulator.view.ViewContext;

/**
 * The world as the software camera draws it, for where JavaFX has no 3D: some pictures a second on
 * a thread of their own, and none while nothing changes. For the JavaFX thread.
 */
final class DrawnPicture implements WorldPicture {

  /** Shortest time from picture to picture [ns]. Decided: 25 a second, to leave time for others. */
  private static final long PERIOD = 40_000_000;

  /**
   * Most pixels. Measured: a million take about 14 ms of a core. A larger one is drawn smaller and
   * stretched.
   */
  private static final double MOST_PIXELS = 1e6;

  private final FxSimulation simulation;
  private final SimulatorCamera camera;
  private final DroneCamera droneCamera;
  private final DrawnAids aids;
  private final Painter painter;
  private final ImageView node = new ImageView();
  private final ScreenPixels pixels = new ScreenPixels(node);
  private ViewCamera seen = ViewCamera.SIMULATOR;
  private long lastNanos = Long.MIN_VALUE;

  DrawnPicture(ViewContext context, SimulatorCamera camera, DroneCamera droneCamera) {
    this.simulation = context.simulation();
    this.camera = camera;
    this.droneCamera = droneCamera;
    aids = new DrawnAids(simulation);
    painter = new Painter(context.video().stage());
    node.setId("drawn-scene");
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

  @Override
  public void lookThrough(ViewCamera newSeen) {
    seen = newSeen;
  }

  @Override
  public void showTrails(boolean shown) {
    aids.showTrails(shown);
  }

  /** They stay as they are: several pixels for each one would take too long. */
  @Override
  public void smoothEdges(boolean smooth) {}

  @Override
  public void advance(long nanos) {
    aids.advance(nanos);
    painter
        .take()
        .ifPresent(
            painted ->
                pixels.show(
                    painted.width(),
                    painted.height(),
                    argb -> System.arraycopy(painted.argb(), 0, argb, 0, argb.length)));
    boolean due = lastNanos == Long.MIN_VALUE || nanos - lastNanos >= PERIOD;
    if (due && !painter.busy() && node.getFitWidth() >= 1 && node.getFitHeight() >= 1) {
      lastNanos = nanos;
      painter.paint(view());
    }
  }

  /** Whether it has nothing new to show. */
  boolean settled() {
    return painter.settled();
  }

  private Painter.View view() {
    double screen =
        node.getScene() == null || node.getScene().getWindow() == null
            ? 1
            : node.getScene().getWindow().getOutputScaleX();
    double area = node.getFitWidth() * node.getFitHeight();
    double scale = Math.min(screen, Math.sqrt(MOST_PIXELS / area));
    int width = (int) Math.max(1, Math.round(scale * node.getFitWidth()));
    int height = (int) Math.max(1, Math.round(scale * node.getFitHeight()));
    if (seen == ViewCamera.DRONE) {
      int drone = simulation.selected().number();
      Pose pose = simulation.selected().poseProperty().get();
      PinholeCamera ahead = droneCamera.optics().ahead(pose, width, height);
      return new Painter.View(simulation.pictured(), OptionalInt.of(drone), ahead, List.of());
    }
    PinholeCamera orbiting =
        new PinholeCamera(camera.pose(), intrinsics(width, height), camera.near());
    return new Painter.View(
        simulation.pictured(), OptionalInt.empty(), orbiting, aids.parts(camera.pose()));
  }

  /** As high as the camera sees, and as wide as the picture then is. */
  private static CameraIntrinsics intrinsics(int width, int height) {
    double half = Math.tan(Math.toRadians(SimulatorCamera.FIELD_OF_VIEW_DEG / 2));
    return new CameraIntrinsics(width, height, 2 * Math.atan(half * width / height));
  }

  @Override
  public void rest() {
    painter.close();
  }
}
