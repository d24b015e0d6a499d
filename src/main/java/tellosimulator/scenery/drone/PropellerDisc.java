package tellosimulator.scenery.drone;

import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.Vertex;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;

/**
 * The motion blur of a propeller at high speed: a translucent two-sided disc with smeared blades.
 * It turns about the z axis, and its centre is at the origin. Lengths are in metres.
 */
final class PropellerDisc {

  private static final int SIDES = 24;

  /** Side length of the texture [texels]. */
  private static final int SIZE = 64;

  private static final Rgb BLADE = Rgb.of(0x3b3e45);

  /** Opacity of the disc. Assumed: by eye. */
  private static final double DISC_OPACITY = 0.18;

  /** Opacity that a smeared blade adds to the opacity of the disc. Assumed: by eye. */
  private static final double BLADE_OPACITY = 0.42;

  private PropellerDisc() {}

  static Mesh mesh() {
    MeshBuilder mesh = new MeshBuilder();
    int hub = mesh.vertex(new Vertex(Vec3.ZERO, Vec3.UP, 0.5, 0.5));
    for (int i = 0; i < SIDES; i++) {
      double angle = 2 * Math.PI * i / SIDES;
      Vec3 out = new Vec3(StrictMath.cos(angle), StrictMath.sin(angle), 0);
      Vec3 rim = out.times(PropellerMesh.RADIUS);
      mesh.vertex(new Vertex(rim, Vec3.UP, 0.5 + out.x() / 2, 0.5 + out.y() / 2));
    }
    for (int i = 0; i < SIDES; i++) {
      int near = hub + 1 + i;
      int far = hub + 1 + (i + 1) % SIDES;
      mesh.triangle(hub, near, far);
      mesh.triangle(hub, far, near); // from below
    }
    return mesh.build();
  }

  static Texture texture() {
    int[] argb = new int[SIZE * SIZE];
    for (int i = 0; i < argb.length; i++) {
      int row = i / SIZE;
      double x = (i - row * SIZE + 0.5) * 2 / SIZE - 1;
      double y = (row + 0.5) * 2 / SIZE - 1;
      argb[i] = BLADE.argb(opacity(x, y));
    }
    return new Texture(SIZE, SIZE, argb);
  }

  /**
   * Returns the opacity of the disc.
   *
   * @param x position along the blades, 1 at a tip
   * @param y position across the blades, in the same unit
   */
  static double opacity(double x, double y) {
    double radius = StrictMath.hypot(x, y);
    double fromBlade = StrictMath.atan2(Math.abs(y), Math.abs(x));
    double blade = StrictMath.exp(-StrictMath.pow(fromBlade / 0.5, 2));
    double tip = Math.max(0, Math.min(1, (1 - radius) * 12));
    return tip * (DISC_OPACITY + BLADE_OPACITY * blade * (1 - 0.45 * radius));
  }
}
