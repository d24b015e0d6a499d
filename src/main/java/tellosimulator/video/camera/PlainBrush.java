package tellosimulator.video.camera;

/** Paints one colour, in changing light. */
final class PlainBrush implements Brush {

  private final Slopes slopes;
  private final long black;
  private int[] pixels = new int[0];
  private float[] nearness = new float[0];
  private int width;
  private long color;

  PlainBrush(Slopes slopes, ColorSpace space) {
    this.slopes = slopes;
    black = Lanes.of(space.black());
  }

  /** From now on paints on this. */
  void on(Raster raster) {
    pixels = raster.pixels();
    nearness = raster.nearness();
    width = raster.width();
  }

  /** From now on paints this colour. */
  void color(long lanes) {
    color = lanes;
  }

  @Override
  public void row(int row, int from, int to) {
    double x = from + 0.5;
    double y = row + 0.5;
    double near = slopes.nearAcross * x + slopes.nearDown * y + slopes.near;
    double light = slopes.lightAcross * x + slopes.lightDown * y + slopes.light;
    double nearStep = slopes.nearAcross;
    double lightStep = slopes.lightAcross;
    int start = row * width;
    if (slopes.even) {
      fill(start + from, start + to, near);
      return;
    }
    for (int i = start + from; i < start + to; i++) {
      if ((float) near > nearness[i]) {
        nearness[i] = (float) near;
        pixels[i] = shaded(light / near);
      }
      near += nearStep;
      light += lightStep;
    }
  }

  /** The same in even light, without a division for each pixel. */
  private void fill(int from, int to, double nearFirst) {
    int one = shaded(slopes.evenLight);
    double near = nearFirst;
    double nearStep = slopes.nearAcross;
    for (int i = from; i < to; i++) {
      if ((float) near > nearness[i]) {
        nearness[i] = (float) near;
        pixels[i] = one;
      }
      near += nearStep;
    }
  }

  private int shaded(double light) {
    int bright = Math.max(0, Math.min(256, (int) (256 * light + 0.5)));
    return Lanes.packed(Lanes.mean(color * bright + black * (256 - bright)));
  }
}
