package tellosimulator.video.camera;

/**
 * Paints a texture. It does so in pieces: only at their ends it divides by the distance, in between
 * everything changes evenly.
 *
 * <p>What a piece starts with and how it changes are fields, not parameters, as there are tens of
 * thousands of pieces in a picture; whoever paints one copies them into variables first, which a
 * processor keeps in registers.
 */
abstract class TextureBrush implements Brush {

  /** Brightness 1. */
  static final int FULL_LIGHT = 256 << 16;

  /** How long a piece is at most. Decided: as long as one version of the texture will do. */
  private static final int LONGEST = 64;

  /** How long a piece is at least. Decided: shorter ones take too long. */
  private static final int SHORTEST = 8;

  /** By how much textures are sharper than pixel for pixel, as an area. */
  private static final double SHARPER = 0.7;

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
  Level level;

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
    double light0 = lit ? light(x, y, distance) : 1;
    int start = row * width;
    int at = from;
    int piece = length(near0, near0 + s.nearAcross * (to - 1 - from));
    while (at < to) {
      int end = Math.min(to, (at | (piece - 1)) + 1);
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
        double light1 = light(x1, y, distance);
        light = (int) (light0 * FULL_LIGHT);
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
   * How long pieces may be, so that in the middle of one that has a pixel of the texture to each of
   * the picture, the texture is at most a quarter of a pixel beside its place. Over a piece of n
   * pixels the distance changes by n times the slope of the nearness, as a share of it, and the
   * place by a quarter of that share of n.
   *
   * @return a power of two
   */
  private int length(double near0, double near1) {
    double most = Math.min(near0, near1) / Math.abs(slopes.nearAcross); // n squared
    int length = SHORTEST;
    while (length < LONGEST && 4.0 * length * length <= most) {
      length *= 2;
    }
    return length;
  }

  /**
   * The version of the texture of which a pixel is about as large as one of the picture; where it
   * is seen at a flat angle, of the same area, but not more than half as long as what falls on one.
   * Measured: with this and {@link #SHARPER}, pictures of the default room come nearest to ones
   * with 16 samples a pixel (40 dB; with the longer side alone 35 dB), and when the camera moves by
   * 1 mm they change as much as these do.
   */
  private int version(double u0, double v0, double distance) {
    double ux = (slopes.uAcross - u0 * slopes.nearAcross) * distance;
    double vx = (slopes.vAcross - v0 * slopes.nearAcross) * distance;
    double uy = (slopes.uDown - u0 * slopes.nearDown) * distance;
    double vy = (slopes.vDown - v0 * slopes.nearDown) * distance;
    double area = Math.abs(ux * vy - uy * vx);
    double longer = Math.max(ux * ux + vx * vx, uy * uy + vy * vy);
    double squared = SHARPER * Math.max(area, longer / 4);
    // The number is half the binary logarithm, rounded.
    int number = (Math.getExponent((float) squared) + 1) >> 1;
    return Math.max(0, Math.min(texture.levels() - 1, number));
  }

  private double light(double x, double y, double distance) {
    double light = slopes.lightAcross * x + slopes.lightDown * y + slopes.light;
    return Math.max(0, Math.min(1, light * distance));
  }

  private static double[] shares() {
    double[] shares = new double[LONGEST + 1];
    for (int steps = 1; steps <= LONGEST; steps++) {
      shares[steps] = 1.0 / steps;
    }
    return shares;
  }
}
