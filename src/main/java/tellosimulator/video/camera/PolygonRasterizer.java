package tellosimulator.video.camera;

/**
 * A scanline rasteriser for convex polygons. It covers the pixels whose centres are inside, and
 * applies the top-left rule to centres on an edge. Edges are always scanned downwards, so a shared
 * edge gives exactly the same columns for both polygons. Each pixel therefore belongs to exactly
 * one of them. Not thread-safe.
 */
final class PolygonRasterizer {

  private int[] leftX = new int[0];
  private int[] rightX = new int[0];
  private int width;
  private int height;

  /** Sets the size of the viewport [pixels]. */
  void setViewport(int newWidth, int newHeight) {
    width = newWidth;
    height = newHeight;
    if (leftX.length < height) {
      leftX = new int[height];
      rightX = new int[height];
    }
  }

  /** Shades the spans of a polygon. Its vertices must be counter-clockwise on the screen. */
  void rasterize(ClippedPolygon polygon, SpanShader shader) {
    double[] xy = polygon.xy;
    int last = 2 * polygon.vertexCount() - 2;
    double top = Double.POSITIVE_INFINITY;
    double bottom = Double.NEGATIVE_INFINITY;
    for (int i = 1; i <= last + 1; i += 2) {
      top = Math.min(top, xy[i]);
      bottom = Math.max(bottom, xy[i]);
    }
    int fromY = Math.max(0, firstPixel(top));
    int toY = Math.min(height, firstPixel(bottom));
    if (fromY >= toY) {
      return;
    }
    for (int i = 0; i <= last; i += 2) {
      int next = i == last ? 0 : i + 2;
      if (xy[i + 1] < xy[next + 1]) {
        scanEdge(xy, i, next, leftX); // downward edges of a counter-clockwise polygon
      } else {
        scanEdge(xy, next, i, rightX);
      }
    }
    for (int y = fromY; y < toY; y++) {
      if (leftX[y] < rightX[y]) {
        shader.shade(y, leftX[y], rightX[y]);
      }
    }
  }

  /** Stores the column of an edge in each scanline. */
  private void scanEdge(double[] xy, int upper, int lower, int[] edgeX) {
    double x = xy[upper];
    double y = xy[upper + 1];
    int fromY = Math.max(0, firstPixel(y));
    int toY = Math.min(height, firstPixel(xy[lower + 1]));
    if (fromY < toY) {
      double slope = (xy[lower] - x) / (xy[lower + 1] - y);
      for (int row = fromY; row < toY; row++) {
        edgeX[row] = Math.max(0, Math.min(width, firstPixel(x + (row + 0.5 - y) * slope)));
      }
    }
  }

  /** Returns the first pixel whose centre is not before a coordinate. */
  private static int firstPixel(double coordinate) {
    return (int) Math.ceil(coordinate - 0.5);
  }
}
