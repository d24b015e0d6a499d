package tellosimulator.video.camera;

/**
 * Finds the pixels of a polygon: those whose middle is inside, and of middles on its edge those on
 * the left and upper one. So each pixel belongs to exactly one of two polygons that share an edge:
 * the edge is always followed downwards, which gives both the very same columns. For one thread.
 */
final class PolygonFiller {

  private int[] left = new int[0];
  private int[] right = new int[0];
  private int width;
  private int height;

  /** From now on fills pictures of this size. */
  void size(int newWidth, int newHeight) {
    width = newWidth;
    height = newHeight;
    if (left.length < height) {
      left = new int[height];
      right = new int[height];
    }
  }

  /** Paints a polygon whose corners are counter-clockwise in the picture. */
  void fill(Outline outline, Brush brush) {
    double[] places = outline.places;
    int last = 2 * outline.corners() - 2;
    double top = Double.POSITIVE_INFINITY;
    double bottom = Double.NEGATIVE_INFINITY;
    for (int i = 1; i <= last + 1; i += 2) {
      top = Math.min(top, places[i]);
      bottom = Math.max(bottom, places[i]);
    }
    int from = Math.max(0, first(top));
    int to = Math.min(height, first(bottom));
    if (from >= to) {
      return;
    }
    for (int i = 0; i <= last; i += 2) {
      int next = i == last ? 0 : i + 2;
      if (places[i + 1] < places[next + 1]) {
        follow(places, i, next, left); // counter-clockwise, down is on the left
      } else {
        follow(places, next, i, right);
      }
    }
    for (int row = from; row < to; row++) {
      if (left[row] < right[row]) {
        brush.row(row, left[row], right[row]);
      }
    }
  }

  /** Notes the column in which an edge is in each row. */
  private void follow(double[] places, int upper, int lower, int[] columns) {
    double x = places[upper];
    double y = places[upper + 1];
    int from = Math.max(0, first(y));
    int to = Math.min(height, first(places[lower + 1]));
    if (from < to) {
      double slope = (places[lower] - x) / (places[lower + 1] - y);
      for (int row = from; row < to; row++) {
        columns[row] = Math.max(0, Math.min(width, first(x + (row + 0.5 - y) * slope)));
      }
    }
  }

  /** The first pixel whose middle is not before a place. */
  private static int first(double place) {
    return (int) Math.ceil(place - 0.5);
  }
}
