package tellosimulator.video.camera;

/**
 * How the properties of a triangle change over the picture. What is linear on the triangle itself
 * is not linear in the picture; but divided by the distance it is, and so is 1 divided by the
 * distance (nearness). Each such property is a plane over the picture, with slopes across and down,
 * and a value at the upper left corner. Filled anew for each triangle; for one thread.
 *
 * <p>The planes are found from the triangle in space, of which parts may be behind the camera.
 */
final class Slopes {

  double nearAcross;
  double nearDown;
  double near;
  double uAcross;
  double uDown;
  double u;
  double vAcross;
  double vDown;
  double v;
  double lightAcross;
  double lightDown;
  double light;

  /** Whether the whole triangle is equally bright, as that of a flat thing is. */
  boolean even;

  /** How bright it then is, 0 to 1. */
  double evenLight;

  /** The inverse of the matrix of the corners, column by column. */
  private final double[] inverse = new double[9];

  /**
   * Looks at a triangle and finds its nearness.
   *
   * @param seen three numbers a point, as {@link Projection} makes them
   * @return whether it is seen from outside
   */
  boolean face(double[] seen, int[] triangle) {
    int a = 3 * triangle[0];
    int b = 3 * triangle[1];
    int c = 3 * triangle[2];
    cross(seen, b, c, 0);
    cross(seen, c, a, 3);
    cross(seen, a, b, 6);
    double volume = seen[a] * inverse[0] + seen[a + 1] * inverse[1] + seen[a + 2] * inverse[2];
    if (!(volume < 0)) {
      return false; // y points down in the picture, so counter-clockwise is negative
    }
    double factor = 1 / volume;
    for (int i = 0; i < 9; i++) {
      inverse[i] *= factor;
    }
    nearAcross = inverse[0] + inverse[3] + inverse[6];
    nearDown = inverse[1] + inverse[4] + inverse[7];
    near = inverse[2] + inverse[5] + inverse[8];
    return true;
  }

  /**
   * Lays the picture on the triangle.
   *
   * @param places u and v of each corner, from an index on
   * @param size the picture
   */
  void texture(float[] places, int at, MipMaps size) {
    double ua = places[at] * size.width();
    double ub = places[at + 2] * size.width();
    double uc = places[at + 4] * size.width();
    uAcross = ua * inverse[0] + ub * inverse[3] + uc * inverse[6];
    uDown = ua * inverse[1] + ub * inverse[4] + uc * inverse[7];
    u = ua * inverse[2] + ub * inverse[5] + uc * inverse[8];
    double va = places[at + 1] * size.height();
    double vb = places[at + 3] * size.height();
    double vc = places[at + 5] * size.height();
    vAcross = va * inverse[0] + vb * inverse[3] + vc * inverse[6];
    vDown = va * inverse[1] + vb * inverse[4] + vc * inverse[7];
    v = va * inverse[2] + vb * inverse[5] + vc * inverse[8];
  }

  /** Lights the triangle: how bright it is at its corners. */
  void light(float[] lights, int[] normals, int at) {
    double a = lights[normals[at]];
    double b = lights[normals[at + 1]];
    double c = lights[normals[at + 2]];
    even = a == b && b == c;
    evenLight = a;
    lightAcross = a * inverse[0] + b * inverse[3] + c * inverse[6];
    lightDown = a * inverse[1] + b * inverse[4] + c * inverse[7];
    light = a * inverse[2] + b * inverse[5] + c * inverse[8];
  }

  /** Lights the triangle fully. */
  void fullLight() {
    even = true;
    evenLight = 1;
    lightAcross = nearAcross;
    lightDown = nearDown;
    light = near;
  }

  private void cross(double[] seen, int a, int b, int to) {
    inverse[to] = seen[a + 1] * seen[b + 2] - seen[a + 2] * seen[b + 1];
    inverse[to + 1] = seen[a + 2] * seen[b] - seen[a] * seen[b + 2];
    inverse[to + 2] = seen[a] * seen[b + 1] - seen[a + 1] * seen[b];
  }
}
