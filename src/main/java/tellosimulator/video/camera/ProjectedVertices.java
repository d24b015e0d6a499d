package tellosimulator.video.camera;

/**
 * The vertices of a mesh after projection: in homogeneous coordinates, in screen coordinates, and
 * as outcodes for clipping. The arrays are reused for each mesh, because a frame has thousands of
 * vertices. Not thread-safe.
 */
final class ProjectedVertices {

  static final int LEFT = 1;
  static final int RIGHT = 2;
  static final int TOP = 4;
  static final int BOTTOM = 8;

  /**
   * Marks a vertex that is nearer than the near plane, or behind the camera. Such a vertex has no
   * screen coordinates.
   */
  static final int NEAR = 16;

  /** x, y and w of each vertex, as computed by {@link ModelViewProjection}. */
  double[] homogeneous = new double[0];

  /** x and y of each vertex on the screen [pixels]. */
  double[] screen = new double[0];

  /** Outcodes (Cohen-Sutherland): the sides of the frustum beyond which each vertex lies. */
  int[] outcodes = new int[0];

  void project(RenderMesh mesh, ModelViewProjection transform) {
    float[] positions = mesh.positions;
    double[] m = transform.matrix();
    int count = positions.length / 3;
    ensureCapacity(count);
    for (int i = 0; i < count; i++) {
      double px = positions[3 * i];
      double py = positions[3 * i + 1];
      double pz = positions[3 * i + 2];
      double x = m[0] * px + m[1] * py + m[2] * pz + m[3];
      double y = m[4] * px + m[5] * py + m[6] * pz + m[7];
      double w = m[8] * px + m[9] * py + m[10] * pz + m[11];
      homogeneous[3 * i] = x;
      homogeneous[3 * i + 1] = y;
      homogeneous[3 * i + 2] = w;
      outcodes[i] =
          (x < 0 ? LEFT : 0)
              | (x > transform.width() * w ? RIGHT : 0)
              | (y < 0 ? TOP : 0)
              | (y > transform.height() * w ? BOTTOM : 0)
              | (w < transform.near() ? NEAR : 0);
      double invW = 1 / w;
      screen[2 * i] = x * invW;
      screen[2 * i + 1] = y * invW;
    }
  }

  private void ensureCapacity(int count) {
    if (outcodes.length < count) {
      homogeneous = new double[3 * count];
      screen = new double[2 * count];
      outcodes = new int[count];
    }
  }
}
