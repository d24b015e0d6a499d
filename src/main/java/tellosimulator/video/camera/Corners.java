package tellosimulator.video.camera;

/**
 * The points of a part, seen by the camera: where each is in the picture, and beyond which of its
 * edges. Plain arrays that are filled anew for each part, as there are thousands of points in a
 * picture. For one thread.
 */
final class Corners {

  static final int LEFT = 1;
  static final int RIGHT = 2;
  static final int ABOVE = 4;
  static final int BELOW = 8;

  /** Too near, or behind the camera; such a point has no place in the picture. */
  static final int NEAR = 16;

  /** Three numbers a point, as {@link Projection} makes them. */
  double[] seen = new double[0];

  /** Two numbers a point: its place in the picture [pixels]. */
  double[] placed = new double[0];

  /** Where each is not in the picture: a sum of the constants above. */
  int[] outside = new int[0];

  void project(Shape shape, Projection projection) {
    float[] points = shape.points;
    double[] m = projection.rows();
    int count = points.length / 3;
    reserve(count);
    for (int i = 0; i < count; i++) {
      double px = points[3 * i];
      double py = points[3 * i + 1];
      double pz = points[3 * i + 2];
      double x = m[0] * px + m[1] * py + m[2] * pz + m[3];
      double y = m[4] * px + m[5] * py + m[6] * pz + m[7];
      double distance = m[8] * px + m[9] * py + m[10] * pz + m[11];
      seen[3 * i] = x;
      seen[3 * i + 1] = y;
      seen[3 * i + 2] = distance;
      outside[i] =
          (x < 0 ? LEFT : 0)
              | (x > projection.width() * distance ? RIGHT : 0)
              | (y < 0 ? ABOVE : 0)
              | (y > projection.height() * distance ? BELOW : 0)
              | (distance < projection.near() ? NEAR : 0);
      double nearness = 1 / distance;
      placed[2 * i] = x * nearness;
      placed[2 * i + 1] = y * nearness;
    }
  }

  private void reserve(int count) {
    if (outside.length < count) {
      seen = new double[3 * count];
      placed = new double[2 * count];
      outside = new int[count];
    }
  }
}
