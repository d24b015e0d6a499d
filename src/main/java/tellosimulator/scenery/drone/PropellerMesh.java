package tellosimulator.scenery.drone;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Mesh;

/**
 * The two blades of a propeller. It turns about the z axis, and its centre is at the origin.
 * Lengths are in metres.
 */
final class PropellerMesh {

  /** Distance from the centre to a tip [m]. Documented: 3-inch propellers (Tello User Manual). */
  static final double RADIUS = 0.0381;

  /**
   * A cross-section of a blade.
   *
   * @param radius distance of the cross-section from the centre [m]
   * @param chord width of the blade [m]
   * @param twist angle of the blade to the plane of the propeller [rad]
   */
  private record Blade(double radius, double chord, double twist) {}

  /** The cross-sections of a blade. Assumed: by eye, from pictures. */
  private static final List<Blade> BLADES =
      List.of(
          new Blade(0.0030, 0.0050, Math.toRadians(30)),
          new Blade(0.0075, 0.0078, Math.toRadians(28)),
          new Blade(0.0140, 0.0104, Math.toRadians(22)),
          new Blade(0.0220, 0.0100, Math.toRadians(17)),
          new Blade(0.0300, 0.0084, Math.toRadians(13)),
          new Blade(0.0355, 0.0062, Math.toRadians(11)),
          new Blade(RADIUS, 0.0028, Math.toRadians(10)));

  private static final double THICKNESS = 0.0009;

  private PropellerMesh() {}

  /**
   * Creates the shape of a propeller.
   *
   * @param clockwise whether the propeller pushes air down when it turns clockwise, seen from above
   */
  static SmoothMeshBuilder shape(boolean clockwise) {
    SmoothMeshBuilder mesh = new SmoothMeshBuilder();
    addBlade(mesh, 1, clockwise);
    addBlade(mesh, -1, clockwise);
    return mesh;
  }

  static Mesh create(boolean clockwise) {
    return shape(clockwise).build();
  }

  private static void addBlade(SmoothMeshBuilder mesh, int side, boolean clockwise) {
    List<int[]> rings = new ArrayList<>();
    for (Blade blade : BLADES) {
      rings.add(section(mesh, blade, side, clockwise ? -1 : 1));
    }
    mesh.group(Palette.PROPELLER);
    Loft.loft(mesh, rings);
  }

  /**
   * Adds four vertices around the middle of a cross-section: one edge, the upper surface, the other
   * edge, and the lower surface.
   */
  private static int[] section(SmoothMeshBuilder mesh, Blade blade, int side, int sense) {
    double flat = blade.chord / 2 * StrictMath.cos(blade.twist);
    double steep = blade.chord / 2 * StrictMath.sin(blade.twist) * sense;
    Vec3 middle = new Vec3(side * blade.radius, 0, 0);
    Vec3 edge = new Vec3(0, side * flat, steep);
    Vec3 back = new Vec3(0, 0, THICKNESS / 2);
    return new int[] {
      mesh.vertex(middle.plus(edge)),
      mesh.vertex(middle.plus(back)),
      mesh.vertex(middle.minus(edge)),
      mesh.vertex(middle.minus(back))
    };
  }
}
