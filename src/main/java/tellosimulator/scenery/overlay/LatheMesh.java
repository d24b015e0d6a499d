package tellosimulator.scenery.overlay;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.Vertex;

/** Builds surfaces of revolution about the z axis, for materials that no light shines on. */
final class LatheMesh {

  /**
   * A point of the outline.
   *
   * @param radius from the axis [m]
   * @param height along the axis [m]
   */
  record Point(double radius, double height) {}

  /**
   * How far a texture goes.
   *
   * @param first where the outline begins, 0 is the upper edge
   * @param last where it ends
   */
  record Range(double first, double last) {

    /** A whole texture from its lower to its upper edge, without what a filter mixes of both. */
    static Range upwards(int texels) {
      return new Range(1 - 0.5 / texels, 0.5 / texels);
    }

    /** The same from its upper to its lower edge. */
    Range reversed() {
      return new Range(last, first);
    }
  }

  private LatheMesh() {}

  /**
   * The surface that an outline sweeps. Where the outline goes up, it is seen from outside; where
   * it goes down, from inside. The texture goes once around.
   *
   * @param sides how many flat sides make it round
   * @param along texture coordinate v of the first and of the last point
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

  /** A ball of radius 1 around the origin. */
  static Mesh ball(int sides) {
    List<Point> outline = new ArrayList<>();
    for (int i = 0; i <= sides / 2; i++) {
      double angle = Math.PI * (2.0 * i / sides - 0.5);
      outline.add(new Point(StrictMath.cos(angle), StrictMath.sin(angle)));
    }
    return of(outline, sides, Range.upwards(GoalTextures.DOWN));
  }

  /**
   * A ring around the origin, in the plane across the axis.
   *
   * @param radius from its middle to that of the tube [m]
   * @param tube radius of the tube [m]
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
