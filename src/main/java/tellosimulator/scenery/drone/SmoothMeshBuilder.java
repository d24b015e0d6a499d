package tellosimulator.scenery.drone;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Mesh;

/**
 * Collects coloured triangles and builds one mesh from them. Triangles in the same smoothing group
 * share normals at their vertices and look like a curved surface; between groups there is a hard
 * edge. The vertices of a triangle are counter-clockwise seen from outside. Not thread-safe.
 */
final class SmoothMeshBuilder {

  /** A triangle: the indices of its vertices, its smoothing group and its colour. */
  record Triangle(int a, int b, int c, int group, Palette color) {}

  private record Corner(int vertex, int group) {}

  private final List<Vec3> vertices = new ArrayList<>();
  private final List<Triangle> triangles = new ArrayList<>();
  private Palette color = Palette.COVER;
  private int group;

  /** Begins a smoothing group, and sets the colour of all subsequent triangles. */
  void group(Palette newColor) {
    group++;
    color = newColor;
  }

  /** Begins a smoothing group with the current colour. */
  void group() {
    group++;
  }

  /** Sets the colour of all subsequent triangles, without beginning a smoothing group. */
  void color(Palette newColor) {
    color = newColor;
  }

  /**
   * Adds a vertex.
   *
   * @return the index of the vertex
   */
  int vertex(Vec3 position) {
    vertices.add(position);
    return vertices.size() - 1;
  }

  /** Adds a triangle, unless its area is zero. */
  void triangle(int a, int b, int c) {
    Triangle added = new Triangle(a, b, c, group, color);
    if (area(added).norm() > 0) {
      triangles.add(added);
    }
  }

  List<Vec3> vertices() {
    return List.copyOf(vertices);
  }

  List<Triangle> triangles() {
    return List.copyOf(triangles);
  }

  /** Returns the outward normal of a triangle; its length is twice the triangle's area. */
  Vec3 area(Triangle triangle) {
    Vec3 a = vertices.get(triangle.a);
    return vertices.get(triangle.b).minus(a).cross(vertices.get(triangle.c).minus(a));
  }

  Mesh build() {
    Map<Corner, Vec3> normals = normals();
    Map<Corner, Integer> numbers = new LinkedHashMap<>();
    normals.keySet().forEach(corner -> numbers.put(corner, numbers.size()));
    int[] corners = new int[9 * triangles.size()];
    int next = 0;
    for (Triangle triangle : triangles) {
      for (int vertex : new int[] {triangle.a, triangle.b, triangle.c}) {
        corners[next++] = vertex;
        corners[next++] = numbers.get(new Corner(vertex, triangle.group));
        corners[next++] = triangle.color.index();
      }
    }
    List<Vec3> unit = normals.values().stream().map(Vec3::normalized).toList();
    return new Mesh(Mesh.floats(vertices), Mesh.floats(unit), Palette.texCoords(), corners);
  }

  /** Returns, for each vertex in each group, the mean normal of its triangles, weighted by area. */
  private Map<Corner, Vec3> normals() {
    Map<Corner, Vec3> normals = new LinkedHashMap<>();
    for (Triangle triangle : triangles) {
      Vec3 area = area(triangle);
      for (int vertex : new int[] {triangle.a, triangle.b, triangle.c}) {
        normals.merge(new Corner(vertex, triangle.group), area, Vec3::plus);
      }
    }
    return normals;
  }
}
