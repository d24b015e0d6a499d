package tellosimulator.scenery.mesh;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Vec3;

/** Collects vertices and triangles and builds one mesh from them. Not thread-safe. */
public final class MeshBuilder {

  /**
   * A vertex.
   *
   * @param position position of the vertex [m]
   * @param normal unit vector
   * @param u texture coordinate; 1 is the right edge
   * @param v texture coordinate; 1 is the lower edge
   */
  public record Vertex(Vec3 position, Vec3 normal, double u, double v) {}

  /**
   * A rectangle whose front is seen with {@code right} pointing to the right and {@code up}
   * pointing upwards.
   *
   * @param corner lower left corner [m]
   * @param right vector along the lower edge [m]
   * @param up vector along the left edge [m]
   */
  public record Quad(Vec3 corner, Vec3 right, Vec3 up) {

    /**
     * Returns a square on the floor, centred at the origin. The {@code up} vector of the square
     * points along the x axis.
     *
     * @param size side length of the square [m]
     */
    public static Quad onFloor(double size) {
      return new Quad(
          new Vec3(-size / 2, size / 2, 0), new Vec3(0, -size, 0), new Vec3(size, 0, 0));
    }

    /** Returns the unit normal, which points towards the viewer. */
    public Vec3 normal() {
      return right.cross(up).normalized();
    }
  }

  /**
   * A rectangle within a texture, in texture coordinates; beyond 1 the texture repeats.
   *
   * @param left u of the left edge
   * @param top v of the upper edge
   */
  public record TextureRegion(double left, double top, double width, double height) {

    /** The whole texture. */
    public static final TextureRegion WHOLE = new TextureRegion(0, 0, 1, 1);

    /**
     * Returns the region that shows a whole texture without wrapping around at its edges: from the
     * centre of the first texel to the centre of the last one.
     */
    public static TextureRegion unwrapped(Texture texture) {
      double across = 1.0 / texture.width();
      double down = 1.0 / texture.height();
      return new TextureRegion(across / 2, down / 2, 1 - across, 1 - down);
    }
  }

  private final List<Vertex> vertices = new ArrayList<>();
  private final List<Integer> indices = new ArrayList<>();

  public boolean isEmpty() {
    return indices.isEmpty();
  }

  /** Adds a vertex and returns its index. */
  public int vertex(Vertex vertex) {
    vertices.add(vertex);
    return vertices.size() - 1;
  }

  /** Adds a triangle, with its vertices counter-clockwise seen from outside. */
  public void triangle(int a, int b, int c) {
    indices.add(a);
    indices.add(b);
    indices.add(c);
  }

  /**
   * Adds a strip of triangles between two rows of vertices.
   *
   * @param lower from left to right, seen from outside
   * @param upper the same number of vertices, above the vertices of {@code lower}
   */
  public void strip(List<Vertex> lower, List<Vertex> upper) {
    int first = vertices.size();
    vertices.addAll(lower);
    vertices.addAll(upper);
    int count = lower.size();
    for (int i = first; i < first + count - 1; i++) {
      triangle(i, i + 1, i + 1 + count);
      triangle(i, i + 1 + count, i + count);
    }
  }

  /**
   * Adds a convex polygon, or nothing if there are fewer than three corners.
   *
   * @param corners counter-clockwise seen from outside
   */
  public MeshBuilder polygon(List<Vertex> corners) {
    int[] added = corners.stream().mapToInt(this::vertex).toArray();
    for (int i = 2; i < added.length; i++) {
      triangle(added[0], added[i - 1], added[i]);
    }
    return this;
  }

  /** Adds a rectangle that shows a region of the texture. */
  public MeshBuilder quad(Quad quad, TextureRegion region) {
    Vec3 normal = quad.normal();
    double right = region.left + region.width;
    double bottom = region.top + region.height;
    Vec3 end = quad.corner.plus(quad.right);
    strip(
        List.of(
            new Vertex(quad.corner, normal, region.left, bottom),
            new Vertex(end, normal, right, bottom)),
        List.of(
            new Vertex(quad.corner.plus(quad.up), normal, region.left, region.top),
            new Vertex(end.plus(quad.up), normal, right, region.top)));
    return this;
  }

  /** Adds the six sides of an axis-aligned box, with the whole texture on each. */
  public MeshBuilder box(Vec3 middle, Vec3 size) {
    Vec3 depth = new Vec3(size.x(), 0, 0);
    Vec3 width = new Vec3(0, size.y(), 0);
    Vec3 height = new Vec3(0, 0, size.z());
    sides(middle, depth, width, height);
    sides(middle, width, height, depth);
    sides(middle, height, depth, width);
    return this;
  }

  /** Adds the two sides of a box that are perpendicular to {@code across}. */
  private void sides(Vec3 middle, Vec3 across, Vec3 right, Vec3 up) {
    Vec3 corner = middle.plusScaled(right, -0.5).plusScaled(up, -0.5);
    quad(new Quad(corner.plusScaled(across, 0.5), right, up), TextureRegion.WHOLE);
    Vec3 other = corner.plusScaled(across, -0.5).plus(right);
    quad(new Quad(other, right.times(-1), up), TextureRegion.WHOLE);
  }

  /** Builds the mesh from all triangles added so far. */
  public Mesh build() {
    int count = vertices.size();
    float[] texCoords = new float[2 * count];
    for (int i = 0; i < count; i++) {
      texCoords[2 * i] = (float) vertices.get(i).u;
      texCoords[2 * i + 1] = (float) vertices.get(i).v;
    }
    int[] faces = new int[3 * indices.size()];
    for (int i = 0; i < faces.length; i++) {
      faces[i] = indices.get(i / 3);
    }
    return new Mesh(
        Mesh.floats(vertices.stream().map(Vertex::position).toList()),
        Mesh.floats(vertices.stream().map(Vertex::normal).toList()),
        texCoords,
        faces);
  }

  /** Returns a mesh of one rectangle that shows a whole texture. */
  public static Mesh of(Quad quad) {
    return new MeshBuilder().quad(quad, TextureRegion.WHOLE).build();
  }
}
