package tellosimulator.video.camera;

/**
 * A triangle after clipping against the near plane. The result is a convex polygon of three or four
 * vertices in screen coordinates. Reused for each triangle. Not thread-safe.
 *
 * <p>Triangles are clipped only against the near plane. The sides of the frustum need no clipping:
 * coordinates far outside the screen are just large numbers, and the rasteriser limits scanlines
 * and spans to the viewport.
 */
final class ClippedPolygon {

  /** x and y of each vertex [pixels]. */
  final double[] xy = new double[8];

  private int vertexCount;

  int vertexCount() {
    return vertexCount;
  }

  /**
   * Sets a triangle that lies completely beyond the near plane, unless it is a back face or so
   * small that it covers no pixels. This check is cheap, which matters because most triangles of a
   * distant mesh cover no pixels.
   *
   * @return whether the triangle was set
   */
  boolean setTriangle(ProjectedVertices vertices, int[] triangle) {
    double[] screen = vertices.screen;
    int a = 2 * triangle[0];
    int b = 2 * triangle[1];
    int c = 2 * triangle[2];
    double ax = screen[a];
    double ay = screen[a + 1];
    double bx = screen[b];
    double by = screen[b + 1];
    double cx = screen[c];
    double cy = screen[c + 1];
    if ((bx - ax) * (cy - ay) >= (cx - ax) * (by - ay)) {
      return false; // y points down, so counter-clockwise is negative
    }
    if (!spansPixelCenter(ay, by, cy) || !spansPixelCenter(ax, bx, cx)) {
      return false;
    }
    vertexCount = 0;
    add(ax, ay);
    add(bx, by);
    add(cx, cy);
    return true;
  }

  /**
   * Returns whether the centre of a row or column of pixels lies between the smallest and the
   * largest of three values.
   */
  private static boolean spansPixelCenter(double a, double b, double c) {
    double least = Math.min(a, Math.min(b, c));
    double largest = Math.max(a, Math.max(b, c));
    return Math.ceil(least - 0.5) < Math.ceil(largest - 0.5);
  }

  /** Clips a triangle against the near plane (Sutherland-Hodgman). */
  void clip(ProjectedVertices vertices, int[] triangle, double near) {
    vertexCount = 0;
    for (int i = 0; i < 3; i++) {
      int from = triangle[i];
      int to = triangle[(i + 1) % 3];
      boolean fromInside = (vertices.outcodes[from] & ProjectedVertices.NEAR) == 0;
      boolean toInside = (vertices.outcodes[to] & ProjectedVertices.NEAR) == 0;
      if (fromInside) {
        add(vertices.screen[2 * from], vertices.screen[2 * from + 1]);
      }
      // Interpolates from inside to outside, so that the adjacent triangle gets the same vertex.
      if (fromInside && !toInside) {
        addIntersection(vertices.homogeneous, 3 * from, 3 * to, near);
      } else if (toInside && !fromInside) {
        addIntersection(vertices.homogeneous, 3 * to, 3 * from, near);
      }
    }
  }

  private void addIntersection(double[] homogeneous, int inside, int outside, double near) {
    double t =
        (homogeneous[inside + 2] - near) / (homogeneous[inside + 2] - homogeneous[outside + 2]);
    add(
        (homogeneous[inside] + t * (homogeneous[outside] - homogeneous[inside])) / near,
        (homogeneous[inside + 1] + t * (homogeneous[outside + 1] - homogeneous[inside + 1]))
            / near);
  }

  private void add(double x, double y) {
    xy[2 * vertexCount] = x;
    xy[2 * vertexCount + 1] = y;
    vertexCount++;
  }
}
