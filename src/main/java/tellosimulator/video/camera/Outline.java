package tellosimulator.video.camera;

/**
 * What of a triangle is in front of the camera: a convex polygon of three or four corners, by their
 * places in the picture. Filled anew for each triangle; for one thread.
 *
 * <p>Only the plane before the camera cuts. The picture's edges need not: places far outside are
 * just large numbers, and rows and columns are limited as they are drawn.
 */
final class Outline {

  /** x and y of each corner [pixels]. */
  final double[] places = new double[8];

  private int corners;

  int corners() {
    return corners;
  }

  /**
   * Takes a triangle of which all is in front of the camera, if it is seen from outside and so
   * large that it may have a pixel. Quick, as of a mesh that is far away most triangles have none.
   *
   * @return whether it was taken
   */
  boolean whole(Corners all, int[] triangle) {
    double[] placed = all.placed;
    int a = 2 * triangle[0];
    int b = 2 * triangle[1];
    int c = 2 * triangle[2];
    double ax = placed[a];
    double ay = placed[a + 1];
    double bx = placed[b];
    double by = placed[b + 1];
    double cx = placed[c];
    double cy = placed[c + 1];
    if ((bx - ax) * (cy - ay) >= (cx - ax) * (by - ay)) {
      return false; // y points down in the picture, so counter-clockwise is negative
    }
    if (!hasMiddle(ay, by, cy) || !hasMiddle(ax, bx, cx)) {
      return false;
    }
    corners = 0;
    add(ax, ay);
    add(bx, by);
    add(cx, cy);
    return true;
  }

  /** Whether the middle of a row or column of pixels is between the least and the largest. */
  private static boolean hasMiddle(double a, double b, double c) {
    double least = Math.min(a, Math.min(b, c));
    double largest = Math.max(a, Math.max(b, c));
    return Math.ceil(least - 0.5) < Math.ceil(largest - 0.5);
  }

  /** Takes the part of a triangle that is in front of the plane before the camera. */
  void cut(Corners all, int[] triangle, double near) {
    corners = 0;
    for (int i = 0; i < 3; i++) {
      int from = triangle[i];
      int to = triangle[(i + 1) % 3];
      boolean fromInside = (all.outside[from] & Corners.NEAR) == 0;
      boolean toInside = (all.outside[to] & Corners.NEAR) == 0;
      if (fromInside) {
        add(all.placed[2 * from], all.placed[2 * from + 1]);
      }
      // From inside to outside, so that the triangle beyond the edge gets the very same place.
      if (fromInside && !toInside) {
        addCut(all.seen, 3 * from, 3 * to, near);
      } else if (toInside && !fromInside) {
        addCut(all.seen, 3 * to, 3 * from, near);
      }
    }
  }

  private void addCut(double[] seen, int inside, int outside, double near) {
    double share = (seen[inside + 2] - near) / (seen[inside + 2] - seen[outside + 2]);
    add(
        (seen[inside] + share * (seen[outside] - seen[inside])) / near,
        (seen[inside + 1] + share * (seen[outside + 1] - seen[inside + 1])) / near);
  }

  private void add(double x, double y) {
    places[2 * corners] = x;
    places[2 * corners + 1] = y;
    corners++;
  }
}
