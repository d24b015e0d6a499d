package tellosimulator.video.camera;

import java.util.Arrays;
import java.util.function.IntPredicate;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Placed;
import tellosimulator.scenery.Scene;

/** A small picture in colours, drawn by a software camera, and questions about it. */
final class Screen {

  /** As wide as high, and a right angle from edge to edge: at 1 m one sees 1 m to each side. */
  static final Lens LENS = new Lens(100, 100, Math.PI / 2);

  private final SoftwareCamera camera = new SoftwareCamera(new Props(ColorSpace.RGB));
  private final Raster raster;
  private final int[] argb;

  private Screen(int width, int height) {
    raster = Raster.forScreen(width, height);
    argb = new int[width * height];
  }

  /** What an eye at the origin sees that looks along x. */
  static Screen of(Placed... parts) {
    return of(new Viewpoint(Sketches.ORIGIN, LENS, 0.1), parts);
  }

  /** What an eye at the origin sees. */
  static Screen of(Attitude attitude, Placed... parts) {
    return of(new Viewpoint(new Pose(Vec3.ZERO, attitude), LENS, 0.1), parts);
  }

  static Screen of(Viewpoint viewpoint, Placed... parts) {
    return of(viewpoint, Sketches.scene(parts));
  }

  static Screen of(Viewpoint viewpoint, Scene scene) {
    Screen screen = new Screen(viewpoint.lens().width(), viewpoint.lens().height());
    screen.camera.draw(scene, viewpoint, screen.raster);
    Arrays.setAll(screen.argb, screen.raster::argb);
    return screen;
  }

  int rgb(int x, int y) {
    return argb[y * raster.width() + x] & 0xffffff;
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
    for (int y = 0; y < raster.height(); y++) {
      for (int x = 0; x < raster.width(); x++) {
        sum += rgb(x, y) == (rgb & 0xffffff) ? 0.5 + (across ? x : y) : 0;
      }
    }
    return sum / count(rgb);
  }
}
