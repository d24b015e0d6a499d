package tellosimulator.video.camera;

/**
 * Paints a texture. It follows a row in pieces: only at their ends it divides by the distance, in
 * between everything changes evenly. What lies in the same version of the texture is then looked up
 * and painted at once.
 */
abstract class TextureBrush implements Brush {

  /**
   * How long a piece is at most [pixels]. Decided: as long as one version of the texture will do.
   */
  private static final int LONGEST = 64;

  /** How long a piece is at least. Decided: shorter ones take too long. */
  private static final int SHORTEST = 8;

  /** By how much textures are sharper than pixel for pixel, as an area. */
  private static final double SHARPER = 0.7;

  /** 1 divided by a number of steps; no step at all changes nothing. */
  private static final double[] SHARE = shares();

  /** No version of a texture. */
  private static final int NONE = -1;

  /** Brightness 1, with 16 binary places. */
  private static final int FULL_LIGHT = 256 << 16;

  /** What the pixels get. */
  final Strip strip;

  /** What is painted on. */
  Raster raster = Raster.forScreen(0, 0);

  private final Slopes slopes;
  private final Places places = new Places();
  private final Places colorPlaces = new Places();
  private final boolean masked;
  private MipMaps texture;
  private boolean lit;

  /**
   * @param masked whether the opacity of textures counts
   */
  TextureBrush(Slopes slopes, Strip strip, boolean masked) {
    this.slopes = slopes;
    this.strip = strip;
    this.masked = masked;
  }

  /** From now on paints on this. */
  void on(Raster newRaster) {
    raster = newRaster;
    places.room(raster.width());
    colorPlaces.room(raster.width());
  }

  /** From now on paints this. */
  void texture(MipMaps newTexture, boolean newLit) {
    texture = newTexture;
    lit = newLit;
  }

  /** Whether light changes what is painted. */
  final boolean lit() {
    return lit;
  }

  /**
   * Paints the strip.
   *
   * @param near 1 divided by the distance of the first pixel along the camera's axis [1/m]
   * @param step by how much that grows with each pixel
   */
  abstract void paint(int row, float near, float step);

  @Override
  public void row(int row, int from, int to) {
    Slopes s = slopes;
    double x = from + 0.5;
    double y = row + 0.5;
    double near = s.nearAcross * x + s.nearDown * y + s.near;
    double distance = 1 / near;
    double u = (s.uAcross * x + s.uDown * y + s.u) * distance;
    double v = (s.vAcross * x + s.vDown * y + s.v) * distance;
    double light = lit ? light(x, y, distance) : 1;
    int length = length(near, near + s.nearAcross * (to - 1 - from));
    int version = version(u, v, distance);
    int first = from;
    int at = from;
    while (at < to) {
      int end = Math.min(to, (at | (length - 1)) + 1);
      // The last piece ends with its last pixel, as there may be no triangle beyond.
      int steps = end == to ? end - at - 1 : end - at;
      double share = SHARE[steps];
      x = at + steps + 0.5;
      distance = 1 / (s.nearAcross * x + s.nearDown * y + s.near);
      double nextU = (s.uAcross * x + s.uDown * y + s.u) * distance;
      double nextV = (s.vAcross * x + s.vDown * y + s.v) * distance;
      double uScale = texture.uScale(version);
      double vScale = texture.vScale(version);
      places.from(u * uScale, v * vScale);
      places.fill(
          at - first, end - first, (nextU - u) * uScale * share, (nextV - v) * vScale * share);
      u = nextU;
      v = nextV;
      if (lit) {
        double nextLight = light(x, y, distance);
        brighten(at - first, end - first, light, (nextLight - light) * share);
        light = nextLight;
      }
      at = end;
      int next = at < to ? version(u, v, distance) : NONE;
      if (next != version) {
        lookUp(row, first, at, texture.level(version));
        paint(row, (float) (near + s.nearAcross * (first - from)), (float) s.nearAcross);
        first = at;
        version = next;
      }
    }
  }

  private void brighten(int from, int to, double first, double step) {
    int[] light = strip.light;
    int bright = (int) (first * FULL_LIGHT);
    int add = (int) (step * FULL_LIGHT);
    for (int i = from; i < to; i++) {
      light[i] = bright >> 16;
      bright += add;
    }
  }

  /** Fills the strip. */
  private void lookUp(int row, int from, int to, Level level) {
    strip.from = from;
    strip.count = to - from;
    places.count = to - from;
    places.find(level.first());
    level.first().read(places, strip.first);
    if (masked) {
      level.opacity().read(places, strip.opacity);
    }
    if (!raster.space().coarse()) {
      lookUpColors(places, level);
    } else if (row % 2 == 0) {
      colorPlaces.halve(places, strip.odd());
      colorPlaces.find(level.second());
      lookUpColors(colorPlaces, level);
    }
  }

  private void lookUpColors(Places where, Level level) {
    level.second().read(where, strip.second);
    level.third().read(where, strip.third);
    if (masked) {
      level.colorOpacity().read(where, strip.colorOpacity);
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
