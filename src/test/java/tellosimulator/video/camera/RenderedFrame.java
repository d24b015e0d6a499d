package tellosimulator.video.camera;

import java.util.Arrays;
import java.util.function.IntPredicate;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Scene;
import tellosimulator.scenery.mesh.Instance;

/** A small frame rendered by a software camera, and queries about its pixels. */
final class RenderedFrame {

  /** Square, with a field of view of 90 degrees: at 1 m, 1 m to each side is visible. */
  static final CameraIntrinsics INTRINSICS = new CameraIntrinsics(100, 100, Math.PI / 2);

  private final SoftwareCamera renderer = new SoftwareCamera(new RenderCache(ColorSpace.RGB));
  private final FrameBuffer frameBuffer;
  private final int[] argb;

  private RenderedFrame(int width, int height) {
    frameBuffer = FrameBuffer.forScreen(width, height);
    argb = new int[width * height];
  }

  /** Renders from the origin, looking along x. */
  static RenderedFrame of(Instance... parts) {
    return of(new PinholeCamera(TestScenes.ORIGIN, INTRINSICS, 0.1), parts);
  }

  /** Renders from the origin. */
  static RenderedFrame of(Attitude attitude, Instance... parts) {
    return of(new PinholeCamera(new Pose(Vec3.ZERO, attitude), INTRINSICS, 0.1), parts);
  }

  static RenderedFrame of(PinholeCamera camera, Instance... parts) {
    return of(camera, TestScenes.scene(parts));
  }

  static RenderedFrame of(PinholeCamera camera, Scene scene) {
    RenderedFrame frame =
        new RenderedFrame(camera.intrinsics().width(), camera.intrinsics().height());
    frame.renderer.draw(scene, camera, frame.frameBuffer);
    Arrays.setAll(frame.argb, frame.frameBuffer::argb);
    return frame;
  }

  int rgb(int x, int y) {
    return argb[y * frameBuffer.width() + x] & 0xffffff;
  }

  int[] pixels() {
    return argb;
  }

  int count(int rgb) {
    return count(pixel -> pixel == (rgb & 0xffffff));
  }

  int count(IntPredicate ofRgb) {
    int count = 0;
    for (int pixel : argb) {
      count += ofRgb.test(pixel & 0xffffff) ? 1 : 0;
    }
    return count;
  }

  /** The mean column of the pixels of a colour, in pixels from the left edge. */
  double column(int rgb) {
    return mean(rgb, true);
  }

  /** The mean row of the pixels of a colour, in pixels from the upper edge. */
  double row(int rgb) {
    return mean(rgb, false);
  }

  private double mean(int rgb, boolean across) {
    double sum = 0;
    for (int y = 0; y < frameBuffer.height(); y++) {
      for (int x = 0; x < frameBuffer.width(); x++) {
        sum += rgb(x, y) == (rgb & 0xffffff) ? 0.5 + (across ? x : y) : 0;
      }
    }
    return sum / count(rgb);
  }
}
