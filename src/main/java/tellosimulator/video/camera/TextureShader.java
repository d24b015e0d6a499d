package tellosimulator.video.camera;

/**
 * Shades a mip-mapped texture with bilinear filtering. Perspective is divided out at the ends of
 * affine subspans only, and texture coordinates are interpolated linearly in between. Subspans of
 * one mip level are then sampled and written at once.
 */
abstract class TextureShader implements SpanShader {

  /** Longest subspan [pixels]. Decided: as long as one mip level will do. */
  private static final int MAX_SUBSPAN = 64;

  /** Shortest subspan [pixels]. Decided: shorter ones take too long. */
  private static final int MIN_SUBSPAN = 8;

  /** Level-of-detail bias: a texel's area on the screen where levels change, sharper below 1. */
  private static final double LOD_BIAS = 0.7;

  /** 1 divided by a number of steps; 0 for no step. */
  private static final double[] RECIPROCALS = reciprocals();

  private static final int NO_LEVEL = -1;

  /** Full light, with 16 fractional bits. */
  private static final int FULL_LIGHT = 256 << 16;

  final Span span;
  FrameBuffer frameBuffer = FrameBuffer.forScreen(0, 0);

  private final Gradients gradients;
  private final TextureCoordinates coordinates = new TextureCoordinates();
  private final TextureCoordinates chromaCoordinates = new TextureCoordinates();
  private final boolean alpha;
  private MipMap texture;
  private boolean lit;

  /**
   * @param alpha whether the alpha of textures counts
   */
  private TextureShader(Gradients gradients, Span span, boolean alpha) {
    this.gradients = gradients;
    this.span = span;
    this.alpha = alpha;
  }

  void setTarget(FrameBuffer newFrameBuffer) {
    frameBuffer = newFrameBuffer;
    coordinates.ensureCapacity(frameBuffer.width());
    chromaCoordinates.ensureCapacity(frameBuffer.width());
  }

  /**
   * Sets the texture.
   *
   * @param newLit whether light modulates it
   */
  void setTexture(MipMap newTexture, boolean newLit) {
    texture = newTexture;
    lit = newLit;
  }

  /**
   * Writes the span to the frame buffer.
   *
   * @param invZ of the first pixel [1/m]
   * @param invZdx its derivative by x
   */
  abstract void write(int row, float invZ, float invZdx);

  @Override
  public void shade(int row, int fromX, int toX) {
    Gradients g = gradients;
    double x = fromX + 0.5;
    double y = row + 0.5;
    double invZ = g.invZdx * x + g.invZdy * y + g.invZ;
    double z = 1 / invZ;
    double u = (g.uOverZdx * x + g.uOverZdy * y + g.uOverZ) * z;
    double v = (g.vOverZdx * x + g.vOverZdy * y + g.vOverZ) * z;
    double light = lit ? light(x, y, z) : 1;
    int length = subspanLength(invZ, invZ + g.invZdx * (toX - 1 - fromX));
    int level = mipLevel(u, v, z);
    int first = fromX;
    int at = fromX;
    while (at < toX) {
      int end = Math.min(toX, (at | (length - 1)) + 1);
      // The last subspan ends at its last pixel, as there may be no triangle beyond.
      int steps = end == toX ? end - at - 1 : end - at;
      double reciprocal = RECIPROCALS[steps];
      x = at + steps + 0.5;
      z = 1 / (g.invZdx * x + g.invZdy * y + g.invZ);
      double nextU = (g.uOverZdx * x + g.uOverZdy * y + g.uOverZ) * z;
      double nextV = (g.vOverZdx * x + g.vOverZdy * y + g.vOverZ) * z;
      double uScale = texture.uScale(level);
      double vScale = texture.vScale(level);
      coordinates.setStart(u * uScale, v * vScale);
      coordinates.interpolate(
          at - first,
          end - first,
          (nextU - u) * uScale * reciprocal,
          (nextV - v) * vScale * reciprocal);
      u = nextU;
      v = nextV;
      if (lit) {
        double nextLight = light(x, y, z);
        interpolateLight(at - first, end - first, light, (nextLight - light) * reciprocal);
        light = nextLight;
      }
      at = end;
      int nextLevel = at < toX ? mipLevel(u, v, z) : NO_LEVEL;
      if (nextLevel != level) {
        sample(row, first, at, texture.level(level));
        write(row, (float) (invZ + g.invZdx * (first - fromX)), (float) g.invZdx);
        first = at;
        level = nextLevel;
      }
    }
  }

  private void interpolateLight(int from, int to, double first, double step) {
    int[] light = span.light;
    int intensity = (int) (first * FULL_LIGHT);
    int add = (int) (step * FULL_LIGHT);
    for (int i = from; i < to; i++) {
      light[i] = intensity >> 16;
      intensity += add;
    }
  }

  /** Fills the span from one mip level. */
  private void sample(int row, int fromX, int toX, MipMap.Level level) {
    span.x = fromX;
    span.count = toX - fromX;
    coordinates.count = toX - fromX;
    coordinates.computeIndices(level.first());
    level.first().sample(coordinates, span.first);
    if (alpha) {
      level.alpha().sample(coordinates, span.alpha);
    }
    if (!frameBuffer.space().subsampled()) {
      sampleChroma(coordinates, level);
    } else if (row % 2 == 0) {
      chromaCoordinates.subsample(coordinates, span.firstEven());
      chromaCoordinates.computeIndices(level.second());
      sampleChroma(chromaCoordinates, level);
    }
  }

  private void sampleChroma(TextureCoordinates at, MipMap.Level level) {
    level.second().sample(at, span.second);
    level.third().sample(at, span.third);
    if (alpha) {
      level.chromaAlpha().sample(at, span.chromaAlpha);
    }
  }

  /**
   * The longest subspan whose middle, at one texel a pixel, is at most a quarter of a texel off.
   * Over n pixels depth changes by n times the derivative of 1/z, as a share of it, and texture
   * coordinates are off by a quarter of that share of n.
   *
   * @return a power of two
   */
  private int subspanLength(double invZ0, double invZ1) {
    double squared = Math.min(invZ0, invZ1) / Math.abs(gradients.invZdx);
    int length = MIN_SUBSPAN;
    while (length < MAX_SUBSPAN && 4.0 * length * length <= squared) {
      length *= 2;
    }
    return length;
  }

  /**
   * The mip level whose texels have about the area of a pixel; at grazing angles of the same area,
   * but not more than half as long as a pixel's footprint. Measured: with this and {@link
   * #LOD_BIAS}, frames of the default room come nearest to ones with 16 samples a pixel (40 dB;
   * with the longer side alone 35 dB), and when the camera moves by 1 mm they change as much as
   * these do.
   */
  private int mipLevel(double u, double v, double z) {
    double dudx = (gradients.uOverZdx - u * gradients.invZdx) * z;
    double dvdx = (gradients.vOverZdx - v * gradients.invZdx) * z;
    double dudy = (gradients.uOverZdy - u * gradients.invZdy) * z;
    double dvdy = (gradients.vOverZdy - v * gradients.invZdy) * z;
    double area = Math.abs(dudx * dvdy - dudy * dvdx);
    double longer = Math.max(dudx * dudx + dvdx * dvdx, dudy * dudy + dvdy * dvdy);
    double squared = LOD_BIAS * Math.max(area, longer / 4);
    // The level is half the binary logarithm, rounded.
    int level = (Math.getExponent((float) squared) + 1) >> 1;
    return Math.max(0, Math.min(texture.levels() - 1, level));
  }

  private double light(double x, double y, double z) {
    double lightOverZ =
        gradients.lightOverZdx * x + gradients.lightOverZdy * y + gradients.lightOverZ;
    return Math.max(0, Math.min(1, lightOverZ * z));
  }

  private static double[] reciprocals() {
    double[] reciprocals = new double[MAX_SUBSPAN + 1];
    for (int steps = 1; steps <= MAX_SUBSPAN; steps++) {
      reciprocals[steps] = 1.0 / steps;
    }
    return reciprocals;
  }

  /** Writes an opaque texture, unlit or modulated by light. */
  static final class Opaque extends TextureShader {

    Opaque(Gradients gradients, Span span) {
      super(gradients, span, false);
    }

    @Override
    void write(int row, float invZ, float invZdx) {
      if (super.lit) {
        span.modulate(frameBuffer.space());
      }
      frameBuffer.draw(row, span, invZ, invZdx);
    }
  }

  /** Blends a translucent texture over the frame buffer: decals and see-through surfaces. */
  static final class Translucent extends TextureShader {

    /**
     * Depth bias of decals, as a factor of 1/z. Decided: far more than rounding does to coplanar
     * surfaces, and at 5 m still only 2.5 mm.
     */
    private static final float DECAL_DEPTH_BIAS = 1.0005f;

    private int opacity;
    private float depthBias = 1;

    Translucent(Gradients gradients, Span span) {
      super(gradients, span, true);
    }

    /**
     * Sets the opacity of the whole texture.
     *
     * @param newOpacity 0 to 1
     * @param decal whether it is a decal, which lies on another surface
     */
    void setOpacity(double newOpacity, boolean decal) {
      depthBias = decal ? DECAL_DEPTH_BIAS : 1;
      opacity = (int) Math.round(256 * Math.max(0, Math.min(1, newOpacity)));
    }

    @Override
    void write(int row, float invZ, float invZdx) {
      frameBuffer.blend(row, span, invZ * depthBias, invZdx * depthBias, opacity);
    }
  }
}
