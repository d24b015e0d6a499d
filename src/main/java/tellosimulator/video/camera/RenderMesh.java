package tellosimulator.video.camera;

import tellosimulator.scenery.mesh.Mesh;

/**
 * A mesh laid out for rendering, with its bounding sphere. The arrays must not be modified.
 * Immutable.
 */
final class RenderMesh {

  /** x, y and z of each vertex [m]. */
  final float[] positions;

  /** x, y and z of each normal. */
  final float[] normals;

  /** Three vertex indices for each triangle. */
  final int[] positionIndices;

  /** Three normal indices for each triangle. */
  final int[] normalIndices;

  /** u and v of the three corners of each triangle. */
  final float[] texCoords;

  /**
   * Whether all corners of a triangle have the same texture coordinates; such a triangle has a
   * single colour.
   */
  final boolean[] solid;

  /** Centre of the bounding sphere [m]. */
  final double[] center = new double[3];

  /** Radius of the bounding sphere [m]. */
  final double radius;

  RenderMesh(Mesh mesh) {
    int triangles = mesh.triangles();
    positions = mesh.positionArray();
    normals = mesh.normalArray();
    positionIndices = new int[3 * triangles];
    normalIndices = new int[3 * triangles];
    texCoords = new float[6 * triangles];
    solid = new boolean[triangles];
    int[] corners = mesh.faceArray();
    float[] meshTexCoords = mesh.texCoordArray();
    for (int i = 0; i < 3 * triangles; i++) {
      positionIndices[i] = corners[3 * i];
      normalIndices[i] = corners[3 * i + 1];
      texCoords[2 * i] = meshTexCoords[2 * corners[3 * i + 2]];
      texCoords[2 * i + 1] = meshTexCoords[2 * corners[3 * i + 2] + 1];
    }
    for (int i = 0; i < triangles; i++) {
      solid[i] = sameTexCoords(6 * i, 6 * i + 2) && sameTexCoords(6 * i, 6 * i + 4);
    }
    radius = boundingSphere();
  }

  int triangles() {
    return solid.length;
  }

  private boolean sameTexCoords(int one, int other) {
    return texCoords[one] == texCoords[other] && texCoords[one + 1] == texCoords[other + 1];
  }

  /** Sets the centre to the centre of the axis-aligned bounding box, and returns the radius. */
  private double boundingSphere() {
    for (int axis = 0; axis < 3; axis++) {
      double low = Double.POSITIVE_INFINITY;
      double high = Double.NEGATIVE_INFINITY;
      for (int i = axis; i < positions.length; i += 3) {
        low = Math.min(low, positions[i]);
        high = Math.max(high, positions[i]);
      }
      center[axis] = positions.length == 0 ? 0 : (low + high) / 2;
    }
    double farthest = 0;
    for (int i = 0; i < positions.length; i += 3) {
      double x = positions[i] - center[0];
      double y = positions[i + 1] - center[1];
      double z = positions[i + 2] - center[2];
      farthest = Math.max(farthest, x * x + y * y + z * z);
    }
    return Math.sqrt(farthest);
  }
}
