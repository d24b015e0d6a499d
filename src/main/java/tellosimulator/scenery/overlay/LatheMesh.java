package tellosimulator.scenery.overlay;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.Vertex;

/** Builds surfaces of revolution about the z axis, for unlit materials. */
final class LatheMesh {

  /**
   * A point of an outline.
   *
   * @param radius distance from the axis [m]
   * @param height position along the axis [m]
   */
  record Point(double radius, double height) {}

  /**
   * The range of texture coordinates along an outline.
   *
   * @param first v at the first point of the outline; 0 is the upper edge of the texture
   * @param last v at the last point of the outline
   */
  record Range(double first, double last) {

    /**
     * Returns the range of a whole texture from its lower to its upper edge. It ends at the centres
     * of the outermost texels, because a filter would blend texels across the edges.
     */
    static Range upwards(int texels) {
      return new Range(1 - 0.5 / texels, 0.5 / texels);
    }

    /** Returns the range in the opposite direction. */
    Range reversed() {
      return new Range(last, first);
    }
  }

  private LatheMesh() {}

  /**
   * Returns the surface of revolution of an outline. Where the outline goes up, the surface faces
   * outwards; where it goes down, the surface faces inwards. The texture goes around the axis once.
   *
   * @param sides number of flat sides around the axis
   * @param along texture coordinate v at the first and the last point
   */
  static Mesh of(List<Point> outline, int sides, Range along) {
    MeshBuilder mesh = new MeshBuilder();
    List<Vertex> before = List.of();
    for (int i = 0; i < outline.size(); i++) {
      Point point = outline.get(i);
      double v = along.first + (along.last - along.first) * i / (outline.size() - 1);
      List<Vertex> row = new ArrayList<>();
      for (int side = 0; side <= sides; side++) {
        double part = (double) side / sides;
        Vec3 foot = new Vec3(point.radius, 0, 0).turned(2 * Math.PI * part);
        row.add(new Vertex(foot.withZ(point.height), Vec3.UP, part, v));
      }
      if (i > 0) {
        mesh.strip(before, row);
      }
      before = row;
    }
    return mesh.build();
  }

  /** Returns a ball of radius 1 around the origin. */
  static Mesh ball(int sides) {
    List<Point> outline = new ArrayList<>();
    for (int i = 0; i <= sides / 2; i++) {
      double angle = Math.PI * (2.0 * i / sides - 0.5);
      outline.add(new Point(StrictMath.cos(angle), StrictMath.sin(angle)));
    }
    return of(outline, sides, Range.upwards(GoalTextures.DOWN));
  }

  /**
   * Returns a ring around the origin, in the plane perpendicular to the axis.
   *
   * @param radius distance from the origin to the centre line of the tube [m]
   * @param tube radius of the tube [m]
   * @param sides number of flat sides around the axis
   */
  static Mesh torus(double radius, double tube, int sides) {
    int around = 12;
    List<Point> outline = new ArrayList<>();
    for (int i = 0; i <= around; i++) {
      double angle = 2 * Math.PI * i / around;
      outline.add(new Point(radius + tube * StrictMath.cos(angle), tube * StrictMath.sin(angle)));
    }
    return of(outline, sides, new Range(1, 0));
  }
}
