package tellosimulator.scenery.furniture;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.MeshBuilder.Vertex;

/** Builds curved surfaces in the frame of an obstacle. */
final class CurvedSurfaces {

  private static final Vec3 AHEAD = new Vec3(1, 0, 0);

  private CurvedSurfaces() {}

  /**
   * Adds an upright tube without ends. Its foot is at the origin.
   *
   * @param around length of the texture around the tube [m]; the middle of the texture is at the
   *     front
   */
  static void tube(TexturedMeshBuilder mesh, double radius, double height, double around) {
    List<Vertex> lower = new ArrayList<>();
    List<Vertex> upper = new ArrayList<>();
    int sides = sides(radius);
    for (int i = 0; i <= sides; i++) {
      double part = (double) i / sides;
      Vec3 spoke = spoke(part);
      Vec3 foot = spoke.times(radius);
      lower.add(mesh.vertex(foot, spoke, part * around, 0));
      upper.add(mesh.vertex(foot.withZ(height), spoke, part * around, height));
    }
    mesh.mesh().strip(lower, upper);
  }

  /**
   * Adds a level disc.
   *
   * @param height height of the disc above the foot [m]
   * @param upwards whether the disc faces upwards; otherwise, it faces downwards
   */
  static void disc(TexturedMeshBuilder mesh, double radius, double height, boolean upwards) {
    Vec3 normal = upwards ? Vec3.UP : Vec3.UP.times(-1);
    int sides = sides(radius);
    int middle = mesh.mesh().vertex(mesh.vertex(new Vec3(0, 0, height), normal, radius, radius));
    int first = middle + 1;
    for (int i = 0; i < sides; i++) {
      Vec3 point = spoke((double) i / sides).times(radius);
      double right = upwards ? -point.y() : point.y();
      mesh.mesh()
          .vertex(mesh.vertex(point.withZ(height), normal, radius + right, radius + point.x()));
    }
    for (int i = 0; i < sides; i++) {
      int one = first + i;
      int next = first + (i + 1) % sides;
      mesh.mesh().triangle(middle, upwards ? one : next, upwards ? next : one);
    }
  }

  /**
   * Adds a ring that stands perpendicular to the x axis.
   *
   * @param radius distance from the centre of the ring to the centre line of the tube [m]
   * @param tube radius of the tube [m]
   * @param height height of the ring's centre above the foot [m]
   */
  static void torus(TexturedMeshBuilder mesh, double radius, double tube, double height) {
    int pieces = Math.max(24, sides(radius));
    int sides = Math.max(8, sides(tube) / 2);
    double along = mesh.mapping().closed(2 * Math.PI * radius);
    double around = mesh.mapping().closed(2 * Math.PI * tube);
    List<Vertex> before = List.of();
    for (int side = 0; side <= sides; side++) {
      double turned = (double) side / sides;
      List<Vertex> row = new ArrayList<>();
      for (int piece = 0; piece <= pieces; piece++) {
        double part = (double) piece / pieces;
        Vec3 out = standing(part);
        Vec3 normal = mixed(out, AHEAD, turned);
        Vec3 middle = out.times(radius).plus(new Vec3(0, 0, height));
        row.add(
            mesh.vertex(middle.plusScaled(normal, tube), normal, part * along, turned * around));
      }
      if (side > 0) {
        mesh.mesh().strip(before, row);
      }
      before = row;
    }
  }

  /**
   * Returns a horizontal unit vector. With growing {@code part} it turns from the back to the
   * right: counter-clockwise seen from above.
   */
  private static Vec3 spoke(double part) {
    return mixed(new Vec3(-1, 0, 0), new Vec3(0, -1, 0), part);
  }

  /**
   * Returns a unit vector perpendicular to the x axis. With growing {@code part} it turns from the
   * bottom to the left: counter-clockwise seen from ahead.
   */
  private static Vec3 standing(double part) {
    return mixed(new Vec3(0, 0, -1), new Vec3(0, 1, 0), part);
  }

  /**
   * Returns the unit vector that is reached after a fraction of a turn.
   *
   * @param first direction at the beginning of the turn
   * @param second direction after a quarter turn
   * @param part fraction of a whole turn
   */
  private static Vec3 mixed(Vec3 first, Vec3 second, double part) {
    double angle = 2 * Math.PI * part;
    return first.times(StrictMath.cos(angle)).plusScaled(second, StrictMath.sin(angle));
  }

  /** Returns the number of flat sides that make a surface look round. Decided: by eye. */
  private static int sides(double radius) {
    return (int) Math.max(10, Math.min(48, 8 + Math.round(40 * Math.sqrt(radius)))) / 2 * 2;
  }
}
