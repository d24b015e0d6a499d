package tellosimulator.scenery.drone;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.ToDoubleFunction;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.drone.SmoothMeshBuilder.Triangle;

/** Measures a mesh for tests: its extent, its solids, and whether they are closed. */
final class MeshProbe {

  /** A directed edge of a triangle. */
  private record Edge(int from, int to) {}

  private final SmoothMeshBuilder mesh;

  MeshProbe(SmoothMeshBuilder mesh) {
    this.mesh = mesh;
  }

  double least(ToDoubleFunction<Vec3> coordinate) {
    return mesh.vertices().stream().mapToDouble(coordinate).min().orElseThrow();
  }

  double most(ToDoubleFunction<Vec3> coordinate) {
    return mesh.vertices().stream().mapToDouble(coordinate).max().orElseThrow();
  }

  /** Returns the vertices of the triangles of a colour. */
  List<Vec3> painted(Palette color) {
    List<Vec3> vertices = mesh.vertices();
    return mesh.triangles().stream()
        .filter(triangle -> triangle.color() == color)
        .flatMap(triangle -> List.of(triangle.a(), triangle.b(), triangle.c()).stream())
        .map(vertices::get)
        .toList();
  }

  /** Returns the number of edges without exactly one neighbour in the opposite direction. */
  long openEdges() {
    Map<Edge, Integer> edges = new HashMap<>();
    for (Triangle triangle : mesh.triangles()) {
      edges.merge(new Edge(triangle.a(), triangle.b()), 1, Integer::sum);
      edges.merge(new Edge(triangle.b(), triangle.c()), 1, Integer::sum);
      edges.merge(new Edge(triangle.c(), triangle.a()), 1, Integer::sum);
    }
    return edges.entrySet().stream()
        .filter(
            entry ->
                entry.getValue() != 1
                    || !edges.containsKey(new Edge(entry.getKey().to, entry.getKey().from)))
        .count();
  }

  /** Returns the volume of each solid [m³]; negative if its normals point inwards. */
  List<Double> volumes() {
    int[] solid = new int[mesh.vertices().size()];
    for (int i = 0; i < solid.length; i++) {
      solid[i] = i;
    }
    for (Triangle triangle : mesh.triangles()) {
      solid[root(solid, triangle.a())] = root(solid, triangle.b());
      solid[root(solid, triangle.b())] = root(solid, triangle.c());
    }
    Map<Integer, Double> volumes = new HashMap<>();
    for (Triangle triangle : mesh.triangles()) {
      volumes.merge(root(solid, triangle.a()), volumeBelow(triangle), Double::sum);
    }
    return new ArrayList<>(volumes.values());
  }

  /** Returns the colours of all triangles. */
  Set<Palette> colors() {
    Set<Palette> colors = new HashSet<>();
    mesh.triangles().forEach(triangle -> colors.add(triangle.color()));
    return colors;
  }

  /** Returns the signed volume of the pyramid from the origin. */
  private double volumeBelow(Triangle triangle) {
    List<Vec3> vertices = mesh.vertices();
    Vec3 b = vertices.get(triangle.b());
    Vec3 c = vertices.get(triangle.c());
    return vertices.get(triangle.a()).dot(b.cross(c)) / 6;
  }

  private static int root(int[] solid, int vertex) {
    int at = vertex;
    while (solid[at] != at) {
      at = solid[at];
    }
    return at;
  }
}
