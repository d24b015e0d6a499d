package tellosimulator.scenery.drone;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Vec3;

/** Lofts closed surfaces over circles or rings of vertices. All lengths are in metres. */
final class Loft {

  /** A circular cross-section. */
  record Section(Vec3 center, double radius) {}

  private Loft() {}

  /** Adds a straight round bar. */
  static void bar(SmoothMeshBuilder mesh, Section from, Section to, int sides) {
    tube(mesh, List.of(from, to), sides);
  }

  /**
   * Adds a tube through cross-sections, closed at both ends. Two successive cross-sections with the
   * same centre form a step.
   *
   * @param sides number of flat sides around the tube
   */
  static void tube(SmoothMeshBuilder mesh, List<Section> sections, int sides) {
    List<int[]> rings = new ArrayList<>();
    for (int i = 0; i < sections.size(); i++) {
      rings.add(circle(mesh, sections.get(i), direction(sections, i), sides));
    }
    loft(mesh, rings);
  }

  /**
   * Adds a surface through rings of vertices, closed by flat ends.
   *
   * @param rings the rings; all of them have the same number of vertices, in counter-clockwise
   *     order as seen from beyond the last ring
   */
  static void loft(SmoothMeshBuilder mesh, List<int[]> rings) {
    for (int i = 1; i < rings.size(); i++) {
      band(mesh, rings.get(i - 1), rings.get(i));
    }
    mesh.group();
    cap(mesh, rings.get(rings.size() - 1), false);
    mesh.group();
    cap(mesh, rings.get(0), true);
  }

  /**
   * Adds the surface between two rings.
   *
   * @param far the ring that lies beyond {@code near} in the direction of the surface
   */
  static void band(SmoothMeshBuilder mesh, int[] near, int[] far) {
    for (int i = 0; i < near.length; i++) {
      int next = (i + 1) % near.length;
      mesh.triangle(near[i], near[next], far[next]);
      mesh.triangle(near[i], far[next], far[i]);
    }
  }

  /**
   * Adds a flat end.
   *
   * @param backward whether the end faces against the direction of the rings
   */
  static void cap(SmoothMeshBuilder mesh, int[] ring, boolean backward) {
    List<Vec3> vertices = mesh.vertices();
    Vec3 center = Vec3.ZERO;
    for (int vertex : ring) {
      center = center.plusScaled(vertices.get(vertex), 1.0 / ring.length);
    }
    int middle = mesh.vertex(center);
    for (int i = 0; i < ring.length; i++) {
      int next = ring[(i + 1) % ring.length];
      if (backward) {
        mesh.triangle(middle, next, ring[i]);
      } else {
        mesh.triangle(middle, ring[i], next);
      }
    }
  }

  private static Vec3 direction(List<Section> sections, int i) {
    Vec3 before = sections.get(Math.max(0, i - 1)).center;
    Vec3 after = sections.get(Math.min(sections.size() - 1, i + 1)).center;
    Vec3 direction = after.minus(before);
    return direction.norm() > 1e-9
        ? direction.normalized()
        : sections.get(sections.size() - 1).center.minus(sections.get(0).center).normalized();
  }

  private static int[] circle(SmoothMeshBuilder mesh, Section section, Vec3 direction, int sides) {
    Vec3 reference = Math.abs(direction.z()) > 0.9 ? new Vec3(1, 0, 0) : Vec3.UP;
    Vec3 first = reference.cross(direction).normalized();
    Vec3 second = direction.cross(first);
    int[] ring = new int[sides];
    for (int i = 0; i < sides; i++) {
      double angle = 2 * Math.PI * (i + 0.5) / sides;
      Vec3 out = first.times(StrictMath.cos(angle)).plusScaled(second, StrictMath.sin(angle));
      ring[i] = mesh.vertex(section.center.plusScaled(out, section.radius));
    }
    return ring;
  }
}
