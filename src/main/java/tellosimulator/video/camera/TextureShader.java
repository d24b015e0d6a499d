package tellosimulator.video.camera;

/**
 * Shades surfaces that have a mip-mapped texture, with bilinear filtering. The perspective division
 * is done only at the ends of affine subspans; in between, texture coordinates are interpolated
 * linearly. Consecutive subspans with the same mip level are then sampled and written together.
 */
abstract class TextureShader implements SpanShader {

  /** Maximum length of a subspan [pixels]. Decided: one mip level is sufficient for this length. */
  private static final int MAX_SUBSPAN = 64;

  /** Minimum length of a subspan [pixels]. Decided: shorter subspans would take too long. */
  private static final int MIN_SUBSPAN = 8;

  /**
   * Level-of-detail bias: a factor of the area of a pixel's footprint on the texture. Values below
   * 1 give sharper images.
   */
  private static final double LOD_BIAS = 0.7;

  /** The reciprocal of each number of steps; 0 for no steps. */
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
  private float depthBias = 1;

  /**
   * Creates a shader.
   *
   * @param alpha whether the alpha channel of textures is used
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
   * @param newLit whether light modulates the texture
   */
  void setTexture(MipMap newTexture, boolean newLit) {
    texture = newTexture;
    lit = newLit;
  }

  /** Sets the depth bias, as a factor of 1/z, for surfaces that lie on others. */
  void setDepthBias(float newDepthBias) {
    depthBias = newDepthBias;
  }

  /**
   * Writes the span to the frame buffer.
   *
   * @param invZ 1/z of the first pixel [1/m]
   * @param invZdx derivative of 1/z with respect to x
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
      // The last subspan ends at its last pixel, because the triangle may not extend beyond it.
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
        double firstInvZ = invZ + g.invZdx * (first - fromX);
        write(row, (float) firstInvZ * depthBias, (float) g.invZdx * depthBias);
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

  /** Fills a part of the span from one mip level. */
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
   * Returns the length [pixels] of the longest subspan in whose middle, at one texel per pixel, the
   * texture coordinate is wrong by at most a quarter of a texel. Over n pixels, the relative change
   * in depth is n times the derivative of 1/z, divided by 1/z. The error of the texture coordinate
   * is n times a quarter of this relative change.
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
   * Returns the mip level whose texels have about the area of a pixel. At grazing angles, its
   * texels are at least half as long as a pixel's footprint. Measured: with this rule and {@link
   * #LOD_BIAS}, frames of the default room are closest to frames rendered with 16 samples a pixel
   * (40 dB; with the longer side alone, 35 dB). When the camera moves by 1 mm, both kinds of frames
   * change by the same amount.
   */
  private int mipLevel(double u, double v, double z) {
    double dudx = (gradients.uOverZdx - u * gradients.invZdx) * z;
    double dvdx = (gradients.vOverZdx - v * gradients.invZdx) * z;
    double dudy = (gradients.uOverZdy - u * gradients.invZdy) * z;
    double dvdy = (gradients.vOverZdy - v * gradients.invZdy) * z;
    double area = Math.abs(dudx * dvdy - dudy * dvdx);
    double longer = Math.max(dudx * dudx + dvdx * dvdx, dudy * dudy + dvdy * dvdy);
    double squared = LOD_BIAS * Math.max(area, longer / 4);
    // The level is half of the binary logarithm, rounded.
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

  /** Writes an opaque texture, which is unlit or modulated by light. */
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

  /** Blends a translucent texture over the frame buffer, for decals and translucent surfaces. */
  static final class Translucent extends TextureShader {

    private int opacity;

    Translucent(Gradients gradients, Span span) {
      super(gradients, span, true);
    }

    /**
     * Sets the opacity of the whole texture.
     *
     * @param newOpacity 0 to 1
     */
    void setOpacity(double newOpacity) {
      opacity = (int) Math.round(256 * Math.max(0, Math.min(1, newOpacity)));
    }

    @Override
    void write(int row, float invZ, float invZdx) {
      frameBuffer.blend(row, span, invZ, invZdx, opacity);
    }
  }
}
