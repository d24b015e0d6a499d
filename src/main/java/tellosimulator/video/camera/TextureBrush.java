package tellosimulator.video.camera;

/**
 * Paints a texture. It does so in pieces of up to sixteen pixels: only at their ends it divides by
 * the distance, in between everything changes evenly.
 *
 * <p>What a piece starts with and how it changes are fields, not parameters, as there are tens of
 * thousands of pieces in a picture; whoever paints one copies them into variables first, which a
 * processor keeps in registers.
 */
abstract class TextureBrush implements Brush {

  /** Brightness 1. */
  static final int FULL_LIGHT = 256 << 16;

  /**
   * How long a piece is at most, a power of two. Decided: with longer ones, straight lines near the
   * camera bend visibly.
   */
  private static final int PIECE = 16;

  /** 1 divided by a number of steps; no step at all changes nothing. */
  private static final double[] SHARE = shares();

  /** Half a pixel of the texture: its colours are those of its pixels' middles. */
  private static final int HALF = MipMaps.ONE / 2;

  final Slopes slopes;

  int[] pixels = new int[0];
  float[] nearness = new float[0];
  float near;
  float nearStep;

  /**
   * In pixels of {@link #level}, times {@link MipMaps#ONE}; what an int cannot hold repeats anyway.
   */
  int u;

  int uStep;
  int v;
  int vStep;

  /** From 0 to {@link #FULL_LIGHT}. */
  int light;

  int lightStep;

  /** The version of the texture to paint with. */
  MipMaps.Level level;

  private MipMaps texture;
  private boolean lit;
  private int width;

  TextureBrush(Slopes slopes) {
    this.slopes = slopes;
  }

  /** From now on paints on this. */
  void on(Raster raster) {
    pixels = raster.pixels();
    nearness = raster.nearness();
    width = raster.width();
  }

  /** From now on paints this. */
  void texture(MipMaps newTexture, boolean newLit) {
    texture = newTexture;
    lit = newLit;
  }

  /** Paints a piece. */
  abstract void piece(int from, int to);

  @Override
  public void row(int row, int from, int to) {
    Slopes s = slopes;
    double x = from + 0.5;
    double y = row + 0.5;
    double near0 = s.nearAcross * x + s.nearDown * y + s.near;
    double distance = 1 / near0;
    double u0 = (s.uAcross * x + s.uDown * y + s.u) * distance;
    double v0 = (s.vAcross * x + s.vDown * y + s.v) * distance;
    double light0 = lit ? (s.lightAcross * x + s.lightDown * y + s.light) * distance : 1;
    int start = row * width;
    int at = from;
    while (at < to) {
      int end = Math.min(to, (at | (PIECE - 1)) + 1);
      // The last piece ends with its last pixel, as there may be no triangle beyond.
      int steps = end == to ? end - at - 1 : end - at;
      int number = version(u0, v0, distance);
      level = texture.level(number);
      double x1 = at + steps + 0.5;
      double near1 = s.nearAcross * x1 + s.nearDown * y + s.near;
      distance = 1 / near1;
      double u1 = (s.uAcross * x1 + s.uDown * y + s.u) * distance;
      double v1 = (s.vAcross * x1 + s.vDown * y + s.v) * distance;
      double share = SHARE[steps];
      near = (float) near0;
      nearStep = (float) ((near1 - near0) * share);
      double uScale = texture.uScale(number);
      double vScale = texture.vScale(number);
      u = (int) (long) (u0 * uScale) - HALF;
      v = (int) (long) (v0 * vScale) - HALF;
      uStep = (int) ((u1 - u0) * uScale * share);
      vStep = (int) ((v1 - v0) * vScale * share);
      if (lit) {
        double light1 = (s.lightAcross * x1 + s.lightDown * y + s.light) * distance;
        light = fixed(light0);
        lightStep = (int) ((light1 - light0) * FULL_LIGHT * share);
        light0 = light1;
      }
      piece(start + at, start + end);
      near0 = near1;
      u0 = u1;
      v0 = v1;
      at = end;
    }
  }

  /**
   * The version of the texture of which about one pixel falls on one of the picture, in the
   * direction in which most do.
   */
  private int version(double u0, double v0, double distance) {
    double ux = (slopes.uAcross - u0 * slopes.nearAcross) * distance;
    double vx = (slopes.vAcross - v0 * slopes.nearAcross) * distance;
    double uy = (slopes.uDown - u0 * slopes.nearDown) * distance;
    double vy = (slopes.vDown - v0 * slopes.nearDown) * distance;
    double squared = Math.max(ux * ux + vx * vx, uy * uy + vy * vy);
    // The number is half the binary logarithm, rounded.
    int number = (Math.getExponent((float) squared) + 1) >> 1;
    return Math.max(0, Math.min(texture.levels() - 1, number));
  }

  private static int fixed(double light) {
    return (int) (Math.max(0, Math.min(1, light)) * FULL_LIGHT);
  }

  private static double[] shares() {
    double[] shares = new double[PIECE + 1];
    for (int steps = 1; steps <= PIECE; steps++) {
      shares[steps] = 1.0 / steps;
    }
    return shares;
  }
}
