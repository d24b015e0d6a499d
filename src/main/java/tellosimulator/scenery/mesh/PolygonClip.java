package tellosimulator.scenery.mesh;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.MeshBuilder.Vertex;

/** Clips convex polygons with the Sutherland-Hodgman algorithm. */
public final class PolygonClip {

  private PolygonClip() {}

  /**
   * Clips a polygon at a plane and returns the part behind the plane.
   *
   * @param normal normal of the plane, a unit vector
   * @param limit distance of the plane from the origin along the normal [m]; anything beyond it is
   *     removed
   */
  public static List<Vertex> clipped(List<Vertex> polygon, Vec3 normal, double limit) {
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

  /**
   * Clips a polygon, seen from above, to a rectangle that is centred at the origin.
   *
   * @param halfDepth half the length of the rectangle along x [m]
   * @param halfWidth half the length of the rectangle along y [m]
   */
  public static List<Vertex> inside(List<Vertex> polygon, double halfDepth, double halfWidth) {
    List<Vertex> inside = polygon;
    for (int side : new int[] {1, -1}) {
      inside = clipped(inside, new Vec3(side, 0, 0), halfDepth);
      inside = clipped(inside, new Vec3(0, side, 0), halfWidth);
    }
    return inside;
  }

  private static Vertex between(Vertex from, Vertex to, double part) {
    return new Vertex(
        from.position().plusScaled(to.position().minus(from.position()), part),
        from.normal(),
        from.u() + part * (to.u() - from.u()),
        from.v() + part * (to.v() - from.v()));
  }
}
