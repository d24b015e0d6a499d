package tellosimulator.video.camera;

import java.util.Arrays;

/** Paints one colour, in changing light. */
final class PlainBrush implements Brush {

  private final Slopes slopes;
  private final Strip strip;
  private Raster raster = Raster.forScreen(0, 0);
  private int color;

  PlainBrush(Slopes slopes, Strip strip) {
    this.slopes = slopes;
    this.strip = strip;
  }

  /** From now on paints on this. */
  void on(Raster newRaster) {
    raster = newRaster;
  }

  /**
   * From now on paints this colour.
   *
   * @param packed of the raster's colour space
   */
  void color(int packed) {
    color = packed;
  }

  @Override
  public void row(int row, int from, int to) {
    double x = from + 0.5;
    double y = row + 0.5;
    double near = slopes.nearAcross * x + slopes.nearDown * y + slopes.near;
    strip.from = from;
    strip.count = to - from;
    Arrays.fill(strip.first, 0, strip.count, color >> 16 & 255);
    Arrays.fill(strip.second, 0, strip.count, color >> 8 & 255);
    Arrays.fill(strip.third, 0, strip.count, color & 255);
    light(slopes.lightAcross * x + slopes.lightDown * y + slopes.light, near);
    strip.shade(raster.space());
    raster.draw(row, strip, (float) near, (float) slopes.nearAcross);
  }

  private void light(double lightFirst, double nearFirst) {
    if (slopes.even) { // without a division for each pixel
      Arrays.fill(strip.light, 0, strip.count, bright(slopes.evenLight));
      return;
    }
    double light = lightFirst;
    double near = nearFirst;
    for (int i = 0; i < strip.count; i++) {
      strip.light[i] = bright(light / near);
      light += slopes.lightAcross;
      near += slopes.nearAcross;
    }
  }

  private static int bright(double light) {
    return Math.max(0, Math.min(256, (int) (256 * light + 0.5)));
  }
}
