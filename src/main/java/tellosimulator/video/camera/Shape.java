package tellosimulator.video.camera;

import tellosimulator.scenery.Mesh;

/**
 * A mesh laid out for drawing, with a ball around it. Its arrays are read only. Immutable; for any
 * thread.
 */
final class Shape {

  /** x, y and z of each point [m]. */
  final float[] points;

  /** x, y and z of each normal. */
  final float[] normals;

  /** For each triangle the numbers of its three points. */
  final int[] pointOf;

  /** For each triangle the numbers of its three normals. */
  final int[] normalOf;

  /** For each triangle u and v of its first, second and third corner. */
  final float[] places;

  /** For each triangle whether all corners are at the same place of the picture. */
  final boolean[] plain;

  /** The middle of the ball [m]. */
  final double[] middle = new double[3];

  /** The radius of the ball [m]. */
  final double radius;

  Shape(Mesh mesh) {
    int triangles = mesh.triangles();
    points = mesh.pointArray();
    normals = mesh.normalArray();
    pointOf = new int[3 * triangles];
    normalOf = new int[3 * triangles];
    places = new float[6 * triangles];
    plain = new boolean[triangles];
    int[] corners = mesh.cornerArray();
    float[] texCoords = mesh.texCoordArray();
    for (int i = 0; i < 3 * triangles; i++) {
      pointOf[i] = corners[3 * i];
      normalOf[i] = corners[3 * i + 1];
      places[2 * i] = texCoords[2 * corners[3 * i + 2]];
      places[2 * i + 1] = texCoords[2 * corners[3 * i + 2] + 1];
    }
    for (int i = 0; i < triangles; i++) {
      plain[i] = same(6 * i, 6 * i + 2) && same(6 * i, 6 * i + 4);
    }
    radius = surround();
  }

  int triangles() {
    return plain.length;
  }

  private boolean same(int one, int other) {
    return places[one] == places[other] && places[one + 1] == places[other + 1];
  }

  /** Puts the middle into the middle of the smallest upright box. */
  private double surround() {
    for (int axis = 0; axis < 3; axis++) {
      double low = Double.POSITIVE_INFINITY;
      double high = Double.NEGATIVE_INFINITY;
      for (int i = axis; i < points.length; i += 3) {
        low = Math.min(low, points[i]);
        high = Math.max(high, points[i]);
      }
      middle[axis] = points.length == 0 ? 0 : (low + high) / 2;
    }
    double farthest = 0;
    for (int i = 0; i < points.length; i += 3) {
      double x = points[i] - middle[0];
      double y = points[i + 1] - middle[1];
      double z = points[i + 2] - middle[2];
      farthest = Math.max(farthest, x * x + y * y + z * z);
    }
    return Math.sqrt(farthest);
  }
}
