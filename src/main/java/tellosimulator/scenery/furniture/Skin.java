package tellosimulator.scenery.furniture;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Mesh;
import tellosimulator.scenery.room.Quads.Quad;

/**
 * Collects the surfaces of a thing and makes one mesh of them. Places in the picture are metres, to
 * the right and up as one sees the surface from outside.
 */
final class Skin {

  /**
   * A corner of a surface.
   *
   * @param point metres
   * @param normal unit vector outwards
   * @param right where in the picture it is [m]
   * @param up where in the picture it is [m]
   */
  record Corner(Vec3 point, Vec3 normal, double right, double up) {}

  private final Coat coat;
  private final List<Corner> corners = new ArrayList<>();
  private final List<int[]> triangles = new ArrayList<>();

  Skin(Coat coat) {
    this.coat = coat;
  }

  Coat coat() {
    return coat;
  }

  boolean empty() {
    return triangles.isEmpty();
  }

  /** Adds a corner and gives its number. */
  int corner(Corner corner) {
    corners.add(corner);
    return corners.size() - 1;
  }

  /** Adds a triangle; its corners are counter-clockwise seen from outside. */
  void triangle(int a, int b, int c) {
    triangles.add(new int[] {a, b, c});
  }

  /**
   * The surface between two rows of corners.
   *
   * @param lower row to the right, as one sees it from outside
   * @param upper as many above them
   */
  void band(List<Corner> lower, List<Corner> upper) {
    int first = corners.size();
    corners.addAll(lower);
    corners.addAll(upper);
    int count = lower.size();
    for (int i = first; i < first + count - 1; i++) {
      triangle(i, i + 1, i + 1 + count);
      triangle(i, i + 1 + count, i + count);
    }
  }

  /**
   * A rectangle.
   *
   * @param left where its left edge is in the picture [m]
   * @param low where its lower edge is in the picture [m]
   */
  void quad(Quad quad, double left, double low) {
    Vec3 normal = quad.right().cross(quad.up()).normalized();
    double right = left + quad.right().norm();
    double high = low + quad.up().norm();
    Vec3 above = quad.corner().plus(quad.up());
    band(
        List.of(
            new Corner(quad.corner(), normal, left, low),
            new Corner(quad.corner().plus(quad.right()), normal, right, low)),
        List.of(
            new Corner(above, normal, left, high),
            new Corner(above.plus(quad.right()), normal, right, high)));
  }

  Mesh mesh() {
    float[] points = new float[3 * corners.size()];
    float[] normals = new float[3 * corners.size()];
    float[] places = new float[2 * corners.size()];
    for (int i = 0; i < corners.size(); i++) {
      Corner corner = corners.get(i);
      put(points, i, corner.point);
      put(normals, i, corner.normal);
      places[2 * i] = (float) coat.u(corner.right);
      places[2 * i + 1] = (float) coat.v(corner.up);
    }
    int[] numbers = new int[9 * triangles.size()];
    int next = 0;
    for (int[] triangle : triangles) {
      for (int corner : triangle) {
        numbers[next++] = corner;
        numbers[next++] = corner;
        numbers[next++] = corner;
      }
    }
    return new Mesh(points, normals, places, numbers);
  }

  private static void put(float[] numbers, int index, Vec3 vector) {
    numbers[3 * index] = (float) vector.x();
    numbers[3 * index + 1] = (float) vector.y();
    numbers[3 * index + 2] = (float) vector.z();
  }
}
