package tellosimulator.video.camera;

/**
 * The screen-space gradients of a triangle's attributes, for perspective-correct interpolation. An
 * attribute that is linear on the triangle is not linear on the screen. However, the attribute
 * divided by depth is linear, and so is 1/z. Each of these quantities is stored as a plane
 * equation: its value at the upper left corner of the screen, and its derivatives with respect to x
 * and y. Reused for each triangle. Not thread-safe.
 *
 * <p>The plane equations are derived from homogeneous coordinates (as in Olano and Greer, Triangle
 * Scan Conversion using 2D Homogeneous Coordinates, 1997), so parts of the triangle may be behind
 * the camera.
 */
final class Gradients {

  double invZ;
  double invZdx;
  double invZdy;
  double uOverZ;
  double uOverZdx;
  double uOverZdy;
  double vOverZ;
  double vOverZdx;
  double vOverZdy;
  double lightOverZ;
  double lightOverZdx;
  double lightOverZdy;

  /** Whether all three vertices have the same light, as on a flat surface. */
  boolean constantLight;

  /** The light at all vertices if it is constant, 0 to 1. */
  double lightValue;

  /** The inverse of the matrix of the vertices, column by column. */
  private final double[] inverse = new double[9];

  /**
   * Sets a triangle, and computes the gradient of 1/z.
   *
   * @param homogeneous x, y and w of each vertex, as computed by {@link ModelViewProjection}
   * @return whether the triangle is a front face
   */
  boolean setTriangle(double[] homogeneous, int[] triangle) {
    int a = 3 * triangle[0];
    int b = 3 * triangle[1];
    int c = 3 * triangle[2];
    cross(homogeneous, b, c, 0);
    cross(homogeneous, c, a, 3);
    cross(homogeneous, a, b, 6);
    double determinant =
        homogeneous[a] * inverse[0]
            + homogeneous[a + 1] * inverse[1]
            + homogeneous[a + 2] * inverse[2];
    if (!(determinant < 0)) {
      return false; // y points down, so counter-clockwise is negative
    }
    double factor = 1 / determinant;
    for (int i = 0; i < 9; i++) {
      inverse[i] *= factor;
    }
    invZdx = inverse[0] + inverse[3] + inverse[6];
    invZdy = inverse[1] + inverse[4] + inverse[7];
    invZ = inverse[2] + inverse[5] + inverse[8];
    return true;
  }

  /**
   * Sets the texture coordinates.
   *
   * @param texCoords contains u and v of each vertex, starting at index {@code at}
   */
  void setTexture(float[] texCoords, int at, MipMap texture) {
    double ua = texCoords[at] * texture.width();
    double ub = texCoords[at + 2] * texture.width();
    double uc = texCoords[at + 4] * texture.width();
    uOverZdx = ua * inverse[0] + ub * inverse[3] + uc * inverse[6];
    uOverZdy = ua * inverse[1] + ub * inverse[4] + uc * inverse[7];
    uOverZ = ua * inverse[2] + ub * inverse[5] + uc * inverse[8];
    double va = texCoords[at + 1] * texture.height();
    double vb = texCoords[at + 3] * texture.height();
    double vc = texCoords[at + 5] * texture.height();
    vOverZdx = va * inverse[0] + vb * inverse[3] + vc * inverse[6];
    vOverZdy = va * inverse[1] + vb * inverse[4] + vc * inverse[7];
    vOverZ = va * inverse[2] + vb * inverse[5] + vc * inverse[8];
  }

  /**
   * Sets the light at the vertices.
   *
   * @param intensities the light at each normal
   * @param normalIndices contains the index of each vertex's normal, starting at index {@code at}
   */
  void setLight(float[] intensities, int[] normalIndices, int at) {
    double a = intensities[normalIndices[at]];
    double b = intensities[normalIndices[at + 1]];
    double c = intensities[normalIndices[at + 2]];
    constantLight = a == b && b == c;
    lightValue = a;
    lightOverZdx = a * inverse[0] + b * inverse[3] + c * inverse[6];
    lightOverZdy = a * inverse[1] + b * inverse[4] + c * inverse[7];
    lightOverZ = a * inverse[2] + b * inverse[5] + c * inverse[8];
  }

  /** Sets full light at all vertices. */
  void setFullLight() {
    constantLight = true;
    lightValue = 1;
    lightOverZdx = invZdx;
    lightOverZdy = invZdy;
    lightOverZ = invZ;
  }

  private void cross(double[] homogeneous, int a, int b, int to) {
    inverse[to] = homogeneous[a + 1] * homogeneous[b + 2] - homogeneous[a + 2] * homogeneous[b + 1];
    inverse[to + 1] = homogeneous[a + 2] * homogeneous[b] - homogeneous[a] * homogeneous[b + 2];
    inverse[to + 2] = homogeneous[a] * homogeneous[b + 1] - homogeneous[a + 1] * homogeneous[b];
  }
}
