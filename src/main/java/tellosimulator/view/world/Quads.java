package tellosimulator.view.world;

import javafx.geometry.Rectangle2D;
import javafx.scene.shape.TriangleMesh;
import javafx.scene.shape.VertexFormat;
import tellosimulator.math.Vec3;

/** Collects rectangles with pictures on them and makes one mesh of them. */
final class Quads {

  /** The whole of a picture. */
  static final Rectangle2D WHOLE = new Rectangle2D(0, 0, 1, 1);

  /**
   * A rectangle; one sees it from where {@code right} leads to the right and {@code up} upwards.
   *
   * @param corner at the lower left
   * @param right along the lower edge
   * @param up along the left edge
   */
  record Quad(Vec3 corner, Vec3 right, Vec3 up) {

    /** Flat on the floor, as wide along y as along x. */
    static Quad onFloor(double size) {
      return new Quad(
          new Vec3(-size / 2, size / 2, 0), new Vec3(0, -size, 0), new Vec3(size, 0, 0));
    }
  }

  private final TriangleMesh mesh = new TriangleMesh(VertexFormat.POINT_NORMAL_TEXCOORD);

  /**
   * Adds a rectangle.
   *
   * @param picture the part of the picture that is on it, in parts of its width and height; beyond
   *     1 it repeats
   */
  Quads add(Quad quad, Rectangle2D picture) {
    int vertex = mesh.getPoints().size() / 3;
    Vec3 normal = quad.right.cross(quad.up).normalized();
    addPoint(quad.corner);
    addPoint(quad.corner.plus(quad.right));
    addPoint(quad.corner.plus(quad.right).plus(quad.up));
    addPoint(quad.corner.plus(quad.up));
    mesh.getNormals().addAll((float) normal.x(), (float) normal.y(), (float) normal.z());
    float left = (float) picture.getMinX();
    float top = (float) picture.getMinY();
    float right = (float) picture.getMaxX();
    float bottom = (float) picture.getMaxY();
    mesh.getTexCoords().addAll(left, bottom, right, bottom, right, top, left, top);
    int plane = mesh.getNormals().size() / 3 - 1;
    addFace(plane, vertex, vertex + 1, vertex + 2);
    addFace(plane, vertex, vertex + 2, vertex + 3);
    return this;
  }

  TriangleMesh mesh() {
    return mesh;
  }

  private void addPoint(Vec3 point) {
    mesh.getPoints().addAll((float) point.x(), (float) point.y(), (float) point.z());
  }

  private void addFace(int plane, int... vertices) {
    for (int vertex : vertices) {
      mesh.getFaces().addAll(vertex, plane, vertex);
    }
  }
}
