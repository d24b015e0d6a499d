package tellosimulator.scenery.furniture;

/**
 * The shade of each texel in a square texture, 0 to 1. Coordinates are in texels, measured from the
 * left and from the top. Not thread-safe.
 */
final class ShadowLayer {

  private final int size;
  private float[] shaded;

  /**
   * Creates a layer without any shade.
   *
   * @param size side length of the layer [texels]
   */
  ShadowLayer(int size) {
    this.size = size;
    shaded = new float[size * size];
  }

  /**
   * Shades all texels whose centres lie in a convex polygon. Parts outside the texture are ignored.
   *
   * @param columns columns of the polygon's corners, in order
   * @param rows rows of the same corners
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
   * Blurs the layer with two box filters along each axis, as an approximation of a Gaussian filter.
   * Beyond the edges, the shade of the edge texels continues.
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

  /**
   * Rounds the radius of a box. The result is at least one texel, because edges are not
   * antialiased, and at most the size of the layer.
   */
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

  /**
   * Blurs along the columns. It iterates row by row and keeps a sum for each column, because this
   * is the fastest order for memory access.
   */
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

  /** Adds the shade of this layer to sums over several layers. */
  void addTo(double[] sums) {
    for (int i = 0; i < sums.length; i++) {
      sums[i] += shaded[i];
    }
  }
}
