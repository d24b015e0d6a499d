package tellosimulator.scenery.drone;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.drone.Loft.Section;

/**
 * The shell of a Tello: a rounded cover on a dark underside, with a dark nose that holds the lens.
 * Assumed: by eye, from pictures.
 */
final class Shell {

  /** Height of the seam between the cover and the underside [m]. */
  private static final double SEAM_HEIGHT = 0.0165;

  /** Width at the recessed seam, as a fraction of the full width. */
  private static final double SEAM_DEPTH = 0.96;

  /** Exponent of the superelliptic cross-section: 2 gives an ellipse, larger values are boxier. */
  private static final double BOXINESS = 3.4;

  /** Number of vertices around the shell; half of them are above the seam. */
  private static final int AROUND = 32;

  /** Position along the x axis where the cover ends and the nose begins [m]. */
  private static final double NOSE_BEGINS = 0.0395;

  /**
   * A cross-section of the shell.
   *
   * @param x position along the body's x axis [m]
   * @param halfWidth half of its width [m]
   * @param up height from the seam to the top [m]
   * @param down depth from the seam to the bottom [m]
   */
  private record Rib(double x, double halfWidth, double up, double down) {}

  private static final List<Rib> RIBS =
      List.of(
          new Rib(-0.0470, 0.0110, 0.0080, 0.0055),
          new Rib(-0.0462, 0.0142, 0.0118, 0.0075),
          new Rib(-0.0440, 0.0163, 0.0145, 0.0087),
          new Rib(-0.0400, 0.0176, 0.0163, 0.0093),
          new Rib(-0.0300, 0.0186, 0.0178, 0.0095),
          new Rib(-0.0100, 0.0192, 0.0186, 0.0095),
          new Rib(0.0100, 0.0192, 0.0186, 0.0095),
          new Rib(0.0260, 0.0186, 0.0178, 0.0095),
          new Rib(0.0360, 0.0177, 0.0163, 0.0094),
          new Rib(NOSE_BEGINS, 0.0173, 0.0155, 0.0093),
          new Rib(0.0440, 0.0164, 0.0138, 0.0090),
          new Rib(0.0475, 0.0152, 0.0116, 0.0082),
          new Rib(0.0490, 0.0138, 0.0098, 0.0072),
          new Rib(BodyMesh.NOSE, 0.0122, 0.0082, 0.0062));

  private Shell() {}

  static void addTo(SmoothMeshBuilder mesh) {
    addHull(mesh);
    addLens(mesh);
    addBattery(mesh);
    addSensors(mesh);
  }

  private static void addHull(SmoothMeshBuilder mesh) {
    List<int[]> rings = new ArrayList<>();
    for (Rib rib : RIBS) {
      rings.add(ring(mesh, rib));
    }
    mesh.group(Palette.COVER);
    for (int i = 1; i < rings.size(); i++) {
      boolean nose = RIBS.get(i - 1).x >= NOSE_BEGINS;
      strip(mesh, rings.get(i - 1), rings.get(i), nose);
    }
    mesh.group(Palette.NOSE);
    Loft.cap(mesh, rings.get(rings.size() - 1), false);
    mesh.group(Palette.SEAM);
    Loft.cap(mesh, rings.get(0), true);
  }

  private static void strip(SmoothMeshBuilder mesh, int[] near, int[] far, boolean nose) {
    for (int i = 0; i < AROUND; i++) {
      int next = (i + 1) % AROUND;
      boolean above = i < AROUND / 2;
      mesh.color(nose ? Palette.NOSE : above ? Palette.COVER : Palette.UNDERSIDE);
      mesh.triangle(near[i], near[next], far[next]);
      mesh.triangle(near[i], far[next], far[i]);
    }
  }

  private static int[] ring(SmoothMeshBuilder mesh, Rib rib) {
    int[] ring = new int[AROUND];
    for (int i = 0; i < AROUND; i++) {
      double angle = 2 * Math.PI * i / AROUND;
      double sine = StrictMath.sin(angle);
      double height = sine >= 0 ? rib.up : rib.down;
      boolean seam = i == 0 || i == AROUND / 2;
      double width = seam ? rib.halfWidth * SEAM_DEPTH : rib.halfWidth;
      ring[i] =
          mesh.vertex(
              new Vec3(
                  rib.x,
                  width * superelliptic(StrictMath.cos(angle)),
                  SEAM_HEIGHT + height * superelliptic(sine)));
    }
    return ring;
  }

  private static double superelliptic(double value) {
    return Math.signum(value) * StrictMath.pow(Math.abs(value), 2 / BOXINESS);
  }

  private static void addLens(SmoothMeshBuilder mesh) {
    Vec3 middle = new Vec3(BodyMesh.NOSE, -0.002, BodyMesh.LENS_HEIGHT);
    mesh.group(Palette.LENS_RING);
    Loft.bar(
        mesh,
        new Section(middle.minus(new Vec3(0.004, 0, 0)), 0.0066),
        new Section(middle.plus(new Vec3(0.0012, 0, 0)), 0.0062),
        20);
    mesh.group(Palette.LENS);
    Loft.tube(
        mesh,
        List.of(
            new Section(middle, 0.0048),
            new Section(middle.plus(new Vec3(0.0016, 0, 0)), 0.0046),
            new Section(middle.plus(new Vec3(0.0026, 0, 0)), 0.0024)),
        20);
    Vec3 glint = middle.plus(new Vec3(0.0022, 0.0014, 0.0014));
    mesh.group(Palette.GLINT);
    Loft.bar(
        mesh,
        new Section(glint, 0.0011),
        new Section(glint.plus(new Vec3(0.0007, 0, 0)), 0.0009),
        8);
  }

  /** Adds the visible end of the battery. The battery is inserted from behind. */
  private static void addBattery(SmoothMeshBuilder mesh) {
    mesh.group(Palette.UNDERSIDE);
    Loft.loft(
        mesh,
        List.of(
            batteryEnd(mesh, new Vec3(-0.0455, 0.0125, 0.0068)),
            batteryEnd(mesh, new Vec3(-0.0482, 0.0118, 0.0060))));
  }

  /**
   * Adds a rectangle perpendicular to the x axis.
   *
   * @param size position along x (x), half of the width (y) and half of the height (z) [m]
   */
  private static int[] batteryEnd(SmoothMeshBuilder mesh, Vec3 size) {
    double middle = 0.0185;
    return new int[] {
      mesh.vertex(new Vec3(size.x(), -size.y(), middle - size.z())),
      mesh.vertex(new Vec3(size.x(), -size.y(), middle + size.z())),
      mesh.vertex(new Vec3(size.x(), size.y(), middle + size.z())),
      mesh.vertex(new Vec3(size.x(), size.y(), middle - size.z()))
    };
  }

  /** Adds the two sensors of the vision positioning system on the underside. */
  private static void addSensors(SmoothMeshBuilder mesh) {
    for (double y : new double[] {-0.005, 0.005}) {
      mesh.group(Palette.LENS);
      Loft.bar(
          mesh,
          new Section(new Vec3(-0.012, y, 0.0062), 0.003),
          new Section(new Vec3(-0.012, y, 0.0085), 0.003),
          12);
    }
  }
}
