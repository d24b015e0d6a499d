package tellosimulator.scenery;

import tellosimulator.math.Vec3;

/**
 * Triangles with normals and places in a picture. Metres, in the frame of the thing that it is part
 * of (x ahead, y to the left, z up). Immutable; for any thread.
 *
 * <p>A triangle's corners are counter-clockwise seen from outside; from behind it is not seen. In a
 * picture, u goes from 0 at the left to 1 at the right and v from 0 at the top to 1 at the bottom;
 * beyond that the picture repeats.
 */
public final class Mesh {

  private final float[] points;
  private final float[] normals;
  private final float[] texCoords;
  private final int[] corners;

  /**
   * @param points x, y and z of each [m]
   * @param normals x, y and z of each, of length 1
   * @param texCoords u and v of each
   * @param corners for each corner of each triangle the numbers of its point, normal and place in
   *     the picture: nine numbers a triangle
   */
  public Mesh(float[] points, float[] normals, float[] texCoords, int[] corners) {
    this.points = points.clone();
    this.normals = normals.clone();
    this.texCoords = texCoords.clone();
    this.corners = corners.clone();
    if (corners.length % 9 != 0) {
      throw new IllegalArgumentException(
          "corners has " + corners.length + " numbers, but a triangle has nine");
    }
  }

  public int triangles() {
    return corners.length / 9;
  }

  /** How many points there are. */
  public int points() {
    return points.length / 3;
  }

  /** A point [m]. */
  public Vec3 point(int index) {
    return new Vec3(points[3 * index], points[3 * index + 1], points[3 * index + 2]);
  }

  /** A copy of the points, as they were given. */
  public float[] pointArray() {
    return points.clone();
  }

  /** A copy of the normals, as they were given. */
  public float[] normalArray() {
    return normals.clone();
  }

  /** A copy of the places in the picture, as they were given. */
  public float[] texCoordArray() {
    return texCoords.clone();
  }

  /** A copy of the corners, as they were given. */
  public int[] cornerArray() {
    return corners.clone();
  }
}
