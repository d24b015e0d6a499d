package tellosimulator.scenery.furniture;

/**
 * How much of each texel of a square texture is shaded, 0 to 1. Coordinates are in texels, from the
 * left and from the top. For one thread.
 */
final class ShadowLayer {

  private final int size;
  private float[] shaded;

  /**
   * A layer without any shade.
   *
   * @param size its edge [texels]
   */
  ShadowLayer(int size) {
    this.size = size;
    shaded = new float[size * size];
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
      blurRows(radius(columns));
      blurColumns(radius(rows));
    }
  }

  /** At least one texel, as edges are not antialiased, and never more than there are. */
  private int radius(double texels) {
    return (int) Math.max(1, Math.min(size, Math.round(texels)));
  }

  private void blurRows(int radius) {
    float[] blurred = new float[shaded.length];
    for (int y = 0; y < size; y++) {
      int row = y * size;
      double sum = 0;
      for (int i = -radius; i <= radius; i++) {
        sum += shaded[row + within(i)];
      }
      for (int x = 0; x < size; x++) {
        blurred[row + x] = (float) (sum / (2 * radius + 1));
        sum += shaded[row + within(x + radius + 1)] - shaded[row + within(x - radius)];
      }
    }
    shaded = blurred;
  }

  /** Row by row with a sum for each column, as memory is read fastest. */
  private void blurColumns(int radius) {
    float[] blurred = new float[shaded.length];
    double[] sums = new double[size];
    for (int i = -radius; i <= radius; i++) {
      for (int x = 0; x < size; x++) {
        sums[x] += shaded[within(i) * size + x];
      }
    }
    for (int y = 0; y < size; y++) {
      int entering = within(y + radius + 1) * size;
      int leaving = within(y - radius) * size;
      for (int x = 0; x < size; x++) {
        blurred[y * size + x] = (float) (sums[x] / (2 * radius + 1));
        sums[x] += shaded[entering + x] - shaded[leaving + x];
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
