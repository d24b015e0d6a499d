package tellosimulator.scenery.drone;

import tellosimulator.scenery.Mesh;
import tellosimulator.scenery.Rgb;
import tellosimulator.scenery.Texture;

/**
 * What the eye sees of a propeller that turns fast: a translucent disc in which the blades are
 * smeared; one sees it from above and from below. About z, its middle at the origin [m].
 */
final class PropellerDisc {

  private static final int SIDES = 24;

  private static final int PICTURE_SIZE = 64;

  private static final Rgb BLADE = Rgb.of(0x3b3e45);

  /** Opacity of the disc, and how much a smeared blade adds to it. Assumed: by eye. */
  private static final double DISC_OPACITY = 0.18;

  private static final double BLADE_OPACITY = 0.42;

  private PropellerDisc() {}

  static Mesh create() {
    float[] points = new float[3 * (SIDES + 1)];
    float[] places = new float[2 * (SIDES + 1)];
    int[] corners = new int[2 * 9 * SIDES];
    places[2 * SIDES] = 0.5f;
    places[2 * SIDES + 1] = 0.5f;
    int corner = 0;
    for (int i = 0; i < SIDES; i++) {
      double angle = 2 * Math.PI * i / SIDES;
      points[3 * i] = (float) (PropellerMesh.RADIUS * StrictMath.cos(angle));
      points[3 * i + 1] = (float) (PropellerMesh.RADIUS * StrictMath.sin(angle));
      places[2 * i] = (float) (0.5 + StrictMath.cos(angle) / 2);
      places[2 * i + 1] = (float) (0.5 + StrictMath.sin(angle) / 2);
      int next = (i + 1) % SIDES;
      for (int vertex : new int[] {SIDES, i, next, SIDES, next, i}) {
        corners[corner] = vertex;
        corners[corner + 1] = corner / 9 % 2; // the second triangle is the underside of the first
        corners[corner + 2] = vertex;
        corner += 3;
      }
    }
    return new Mesh(points, new float[] {0, 0, 1, 0, 0, -1}, places, corners);
  }

  static Texture picture() {
    int[] pixels = new int[PICTURE_SIZE * PICTURE_SIZE];
    for (int i = 0; i < pixels.length; i++) {
      int row = i / PICTURE_SIZE;
      double x = (i - row * PICTURE_SIZE + 0.5) * 2 / PICTURE_SIZE - 1;
      double y = (row + 0.5) * 2 / PICTURE_SIZE - 1;
      pixels[i] = BLADE.argb(opacity(x, y));
    }
    return new Texture(PICTURE_SIZE, PICTURE_SIZE, pixels);
  }

  /**
   * How opaque the disc is.
   *
   * @param x along the blades, 1 at a tip
   * @param y across
   */
  static double opacity(double x, double y) {
    double radius = StrictMath.hypot(x, y);
    double fromBlade = StrictMath.atan2(Math.abs(y), Math.abs(x));
    double blade = StrictMath.exp(-StrictMath.pow(fromBlade / 0.5, 2));
    double tip = Math.max(0, Math.min(1, (1 - radius) * 12));
    return tip * (DISC_OPACITY + BLADE_OPACITY * blade * (1 - 0.45 * radius));
  }
}
