package tellosimulator.scenery.furniture;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.MeshBuilder.Vertex;

/** Clips convex polygons (Sutherland-Hodgman). */
final class FloorClip {

  private FloorClip() {}

  /**
   * What of a polygon is on this side of a plane.
   *
   * @param normal of the plane, a unit vector
   * @param limit the farthest that is kept, along the normal from the origin [m]
   */
  static List<Vertex> clipped(List<Vertex> polygon, Vec3 normal, double limit) {
    if (polygon.stream().allMatch(vertex -> vertex.position().dot(normal) <= limit)) {
      return polygon;
    }
    List<Vertex> kept = new ArrayList<>();
    for (int i = 0; i < polygon.size(); i++) {
      Vertex from = polygon.get(i);
      Vertex to = polygon.get((i + 1) % polygon.size());
      double before = from.position().dot(normal) - limit;
      double after = to.position().dot(normal) - limit;
      if (before <= 0) {
        kept.add(from);
      }
      if (Math.min(before, after) <= 0 && Math.max(before, after) > 0) {
        kept.add(between(from, to, before / (before - after)));
      }
    }
    return kept;
  }

  private static Vertex between(Vertex from, Vertex to, double part) {
    return new Vertex(
        from.position().plusScaled(to.position().minus(from.position()), part),
        from.normal(),
        from.u() + part * (to.u() - from.u()),
        from.v() + part * (to.v() - from.v()));
  }
}
