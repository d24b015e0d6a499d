package tellosimulator.scenery.drone;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Mesh;

/**
 * Collects coloured triangles and makes one mesh of them. Triangles that share vertices and a
 * smoothing group look like one curved surface; between groups there is an edge. A triangle's
 * vertices are given counter-clockwise, seen from outside.
 */
final class MeshBuilder {

  /** The vertices of a triangle, the surface that it is part of, and its colour. */
  record Triangle(int a, int b, int c, int group, Palette color) {}

  private record Corner(int vertex, int group) {}

  private final List<Vec3> vertices = new ArrayList<>();
  private final List<Triangle> triangles = new ArrayList<>();
  private Palette color = Palette.COVER;
  private int group;

  /** Begins a new curved surface; what follows has this colour. */
  void surface(Palette newColor) {
    group++;
    color = newColor;
  }

  /** Begins a new curved surface of the same colour. */
  void edge() {
    group++;
  }

  /** What follows has this colour, on the same curved surface. */
  void paint(Palette newColor) {
    color = newColor;
  }

  /**
   * Adds a vertex.
   *
   * @return its index
   */
  int vertex(Vec3 position) {
    vertices.add(position);
    return vertices.size() - 1;
  }

  /** Adds a triangle; one without area is left out. */
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

  /** The outward normal of a triangle, as long as twice its area. */
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
    return new Mesh(numbers(vertices), numbers(unit), Palette.places(), corners);
  }

  private static float[] numbers(List<Vec3> vectors) {
    float[] numbers = new float[3 * vectors.size()];
    for (int i = 0; i < vectors.size(); i++) {
      numbers[3 * i] = (float) vectors.get(i).x();
      numbers[3 * i + 1] = (float) vectors.get(i).y();
      numbers[3 * i + 2] = (float) vectors.get(i).z();
    }
    return numbers;
  }

  /** For each vertex of each surface the mean of its triangles' normals, weighted by area. */
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
