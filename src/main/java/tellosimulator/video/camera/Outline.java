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

  /** Takes a triangle of which all is in front of the camera. */
  void whole(Corners all, int[] triangle) {
    corners = 0;
    for (int point : triangle) {
      add(all.placed[2 * point], all.placed[2 * point + 1]);
    }
  }

  /**
   * Whether a triangle that was taken as a whole is seen from outside and so large that it may have
   * a pixel. Quick, as of a mesh that is far away most triangles have none.
   */
  boolean hasPixels() {
    double[] p = places;
    double area = (p[2] - p[0]) * (p[5] - p[1]) - (p[4] - p[0]) * (p[3] - p[1]);
    if (area >= 0) {
      return false; // y points down in the picture, so counter-clockwise is negative
    }
    double top = Math.min(p[1], Math.min(p[3], p[5]));
    double bottom = Math.max(p[1], Math.max(p[3], p[5]));
    double left = Math.min(p[0], Math.min(p[2], p[4]));
    double right = Math.max(p[0], Math.max(p[2], p[4]));
    return Math.ceil(top - 0.5) < Math.ceil(bottom - 0.5)
        && Math.ceil(left - 0.5) < Math.ceil(right - 0.5);
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
