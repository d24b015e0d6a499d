package tellosimulator.scenery.room;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Mesh;

/** Collects rectangles with pictures on them and makes one mesh of them. */
public final class Quads {

  /**
   * A rectangle; one sees it from where {@code right} leads to the right and {@code up} upwards.
   *
   * @param corner at the lower left
   * @param right along the lower edge
   * @param up along the left edge
   */
  public record Quad(Vec3 corner, Vec3 right, Vec3 up) {

    /** Flat on the floor, its middle at the origin, as wide along y as along x, x upwards. */
    public static Quad onFloor(double size) {
      return new Quad(
          new Vec3(-size / 2, size / 2, 0), new Vec3(0, -size, 0), new Vec3(size, 0, 0));
    }

    private Vec3 normal() {
      return right.cross(up).normalized();
    }

    private List<Vec3> corners() {
      return List.of(corner, corner.plus(right), corner.plus(right).plus(up), corner.plus(up));
    }
  }

  /**
   * A part of a picture, in parts of its width and height; beyond 1 the picture repeats.
   *
   * @param left from its left edge
   * @param top from its top
   */
  public record Patch(double left, double top, double width, double height) {

    /** The whole of a picture. */
    public static final Patch WHOLE = new Patch(0, 0, 1, 1);

    private double[] corners() {
      double right = left + width;
      double bottom = top + height;
      return new double[] {left, bottom, right, bottom, right, top, left, top};
    }
  }

  private record Pasted(Quad quad, Patch patch) {}

  private final List<Pasted> all = new ArrayList<>();

  /**
   * Adds a rectangle.
   *
   * @param patch the part of the picture that is on it
   */
  public Quads add(Quad quad, Patch patch) {
    all.add(new Pasted(quad, patch));
    return this;
  }

  /** The mesh of all of them. */
  public Mesh mesh() {
    int count = all.size();
    float[] points = new float[12 * count];
    float[] normals = new float[3 * count];
    float[] places = new float[8 * count];
    int[] corners = new int[18 * count];
    for (int i = 0; i < count; i++) {
      Pasted pasted = all.get(i);
      put(normals, i, pasted.quad.normal());
      List<Vec3> vertices = pasted.quad.corners();
      double[] patch = pasted.patch.corners();
      for (int j = 0; j < 4; j++) {
        put(points, 4 * i + j, vertices.get(j));
        places[8 * i + 2 * j] = (float) patch[2 * j];
        places[8 * i + 2 * j + 1] = (float) patch[2 * j + 1];
      }
      int corner = 18 * i;
      for (int vertex : new int[] {0, 1, 2, 0, 2, 3}) {
        corners[corner] = 4 * i + vertex;
        corners[corner + 1] = i;
        corners[corner + 2] = 4 * i + vertex;
        corner += 3;
      }
    }
    return new Mesh(points, normals, places, corners);
  }

  private static void put(float[] numbers, int index, Vec3 vector) {
    numbers[3 * index] = (float) vector.x();
    numbers[3 * index + 1] = (float) vector.y();
    numbers[3 * index + 2] = (float) vector.z();
  }
}
