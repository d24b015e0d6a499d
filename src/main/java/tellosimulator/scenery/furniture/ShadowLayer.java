package tellosimulator.scenery.furniture;

/**
 * How much of each texel of a square texture is shaded, 0 to 1. Coordinates are in texels, from the
 * left and from the top. For one thread.
 */
final class ShadowLayer {

  private final int size;
  private double[] shaded;

  /**
   * A layer without any shade.
   *
   * @param size its edge [texels]
   */
  ShadowLayer(int size) {
    this.size = size;
    shaded = new double[size * size];
  }

  /**
   * Shades all texels whose centres are in a convex polygon; what is outside of the texture is left
   * out.
   *
   * @param columns of its corners, one after the other
   * @param rows of its corners
   */
  void fill(double[] columns, double[] rows) {
    double top = Double.POSITIVE_INFINITY;
    double bottom = Double.NEGATIVE_INFINITY;
    for (double row : rows) {
      top = Math.min(top, row);
      bottom = Math.max(bottom, row);
    }
    int last = (int) Math.min(size - 1, Math.floor(bottom - 0.5));
    for (int y = (int) Math.max(0, Math.ceil(top - 0.5)); y <= last; y++) {
      fillRow(y, columns, rows);
    }
  }

  private void fillRow(int y, double[] columns, double[] rows) {
    double center = y + 0.5;
    double left = Double.POSITIVE_INFINITY;
    double right = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < rows.length; i++) {
      int next = (i + 1) % rows.length;
      if (rows[i] <= center != rows[next] <= center) {
        double part = (center - rows[i]) / (rows[next] - rows[i]);
        double column = columns[i] + part * (columns[next] - columns[i]);
        left = Math.min(left, column);
        right = Math.max(right, column);
      }
    }
    int last = (int) Math.min(size - 1, Math.floor(right - 0.5));
    for (int x = (int) Math.max(0, Math.ceil(left - 0.5)); x <= last; x++) {
      shaded[y * size + x] = 1;
    }
  }

  /**
   * Blurs with two box filters along each axis, which is nearly a Gaussian filter. Beyond the edges
   * the shade goes on as it is there.
   *
   * @param columns half the width of a box [texels]
   * @param rows half the height of a box [texels]
   */
  void blur(double columns, double rows) {
    for (int pass = 0; pass < 2; pass++) {
      blurLines((int) Math.round(columns), 1, size);
      blurLines((int) Math.round(rows), size, 1);
    }
  }

  /**
   * A box filter along all lines of one direction.
   *
   * @param radius half the box [texels]
   * @param step from a texel of a line to its next one
   * @param lineStep from a line to the next one
   */
  private void blurLines(int radius, int step, int lineStep) {
    double[] blurred = new double[shaded.length];
    double share = 1.0 / (2 * radius + 1);
    for (int line = 0; line < size; line++) {
      int start = line * lineStep;
      double sum = 0;
      for (int i = -radius; i <= radius; i++) {
        sum += shaded[start + within(i) * step];
      }
      for (int i = 0; i < size; i++) {
        blurred[start + i * step] = sum * share;
        sum += shaded[start + within(i + radius + 1) * step];
        sum -= shaded[start + within(i - radius) * step];
      }
    }
    shaded = blurred;
  }

  private int within(int texel) {
    return Math.max(0, Math.min(size - 1, texel));
  }

  /** Adds the shade to that of other layers. */
  void addTo(double[] sums) {
    for (int i = 0; i < sums.length; i++) {
      sums[i] += shaded[i];
    }
  }
}
