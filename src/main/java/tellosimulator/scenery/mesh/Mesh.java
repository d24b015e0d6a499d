package tellosimulator.scenery.mesh;

import java.util.List;
import tellosimulator.math.Vec3;

/**
 * An indexed triangle mesh with normals and texture coordinates. All lengths are in metres, in the
 * mesh's own frame (x ahead, y to the left, z up). Immutable. Meshes are compared by identity, so a
 * renderer converts each mesh only once.
 *
 * <p>The vertices of a triangle are counter-clockwise seen from outside; its back face is culled.
 * Texture coordinates go from 0 at the left to 1 at the right (u), and from 0 at the top to 1 at
 * the bottom (v). Outside this range the texture repeats.
 */
public final class Mesh {

  private final float[] positions;
  private final float[] normals;
  private final float[] texCoords;
  private final int[] faces;

  /**
   * Creates a mesh from copies of the arrays.
   *
   * @param positions x, y and z of each position [m]
   * @param normals x, y and z of each normal, which is a unit vector
   * @param texCoords u and v of each pair of texture coordinates
   * @param faces for each vertex of each triangle, the indices of its position, its normal and its
   *     texture coordinates: nine numbers for each triangle
   */
  public Mesh(float[] positions, float[] normals, float[] texCoords, int[] faces) {
    this.positions = positions.clone();
    this.normals = normals.clone();
    this.texCoords = texCoords.clone();
    this.faces = faces.clone();
    if (faces.length % 9 != 0) {
      throw new IllegalArgumentException(
          "faces has " + faces.length + " numbers, but a triangle has nine");
    }
  }

  /** Converts vectors to the format of a mesh: x, y and z of each vector. */
  public static float[] floats(List<Vec3> vectors) {
    float[] floats = new float[3 * vectors.size()];
    int next = 0;
    for (Vec3 vector : vectors) {
      floats[next++] = (float) vector.x();
      floats[next++] = (float) vector.y();
      floats[next++] = (float) vector.z();
    }
    return floats;
  }

  public int triangles() {
    return faces.length / 9;
  }

  /** Returns the number of positions. */
  public int positions() {
    return positions.length / 3;
  }

  /** Returns a position [m]. */
  public Vec3 position(int index) {
    return new Vec3(positions[3 * index], positions[3 * index + 1], positions[3 * index + 2]);
  }

  /** Returns a copy of the positions. */
  public float[] positionArray() {
    return positions.clone();
  }

  /** Returns a copy of the normals. */
  public float[] normalArray() {
    return normals.clone();
  }

  /** Returns a copy of the texture coordinates. */
  public float[] texCoordArray() {
    return texCoords.clone();
  }

  /** Returns a copy of the faces. */
  public int[] faceArray() {
    return faces.clone();
  }
}
