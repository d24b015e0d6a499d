package tellosimulator.video.camera;

import tellosimulator.scenery.mesh.Texture;

/**
 * A texture image in some size and colour space, used while the mip levels are built. The first
 * column and row are repeated after the last ones, so that neighbours wrap around. Immutable.
 *
 * <p>A texel is stored with 8 bits for each channel, and computed with as a long with 16 bits for
 * each channel. One multiplication therefore weights all four channels, because 255 times a weight
 * of 256 still fits into 16 bits.
 */
final class Texels {

  /** The shift of the first channel within a stored texel. */
  static final int FIRST = 16;

  static final int SECOND = 8;
  static final int THIRD = 0;
  static final int ALPHA = 24;

  /** The low 8 bits of each channel of a long. */
  private static final long MASK = 0x00ff00ff00ff00ffL;

  private static final long HALF = 0x0080008000800080L;
  private static final long TWO = 0x0002000200020002L;

  private final int width;
  private final int height;

  /** The texels row by row, with one additional column and row. */
  private final int[] texels;

  private Texels(int width, int height) {
    this.width = width;
    this.height = height;
    texels = new int[(width + 1) * (height + 1)];
  }

  /**
   * Creates the texels of a texture in its original size.
   *
   * @param alpha whether the alpha channel is used; if so, colours are premultiplied with it
   */
  static Texels of(Texture texture, ColorSpace space, boolean alpha) {
    Texels made = new Texels(texture.width(), texture.height());
    for (int y = 0; y < made.height; y++) {
      for (int x = 0; x < made.width; x++) {
        int argb = texture.argb(x, y);
        int opaque = space.pack(argb | 0xff000000);
        made.texels[made.index(x, y)] = alpha ? premultiplied(opaque, argb >>> 24) : opaque;
      }
    }
    made.wrapEdges();
    return made;
  }

  int width() {
    return width;
  }

  int height() {
    return height;
  }

  /**
   * Returns one channel, prepared for bilinear filtering.
   *
   * @param shift the shift of the channel
   */
  BilinearTexels channel(int shift) {
    int[] packed = new int[BilinearTexels.size(width, height)];
    for (int y = 0; y < height; y++) {
      int at = index(0, y);
      int left = column(at, shift);
      for (int x = 0; x < width; x++) {
        at++;
        int right = column(at, shift);
        packed[BilinearTexels.index(x, y, width)] = left | (right << 8);
        left = right;
      }
    }
    return new BilinearTexels(width, height, packed);
  }

  /** Returns a texel in the lowest 8 bits, and the texel below it 16 bits higher. */
  private int column(int at, int shift) {
    int upper = (texels[at] >>> shift) & 255;
    int lower = (texels[at + width + 1] >>> shift) & 255;
    return upper | (lower << 16);
  }

  /** Downsamples with a box filter of 2x2 texels. A side of one texel is kept. */
  Texels halved() {
    Texels half = new Texels(Math.max(1, width / 2), Math.max(1, height / 2));
    int right = width > 1 ? 1 : 0;
    int below = height > 1 ? width + 1 : 0;
    for (int y = 0; y < half.height; y++) {
      for (int x = 0; x < half.width; x++) {
        int i = index(right == 0 ? 0 : 2 * x, below == 0 ? 0 : 2 * y);
        long sum = texel(i) + texel(i + right) + texel(i + below) + texel(i + below + right);
        half.texels[half.index(x, y)] = packed(((sum + TWO) >>> 2) & MASK);
      }
    }
    half.wrapEdges();
    return half;
  }

  /**
   * Resamples each side to the next power of two, but not above a limit.
   *
   * @param maxSize the limit, a power of two
   */
  Texels powerOfTwo(int maxSize) {
    Texels small = this;
    while (small.width > 2 * maxSize || small.height > 2 * maxSize) {
      small = small.halved();
    }
    return small.resampled(
        Math.min(maxSize, ceilingPowerOfTwo(small.width)),
        Math.min(maxSize, ceilingPowerOfTwo(small.height)));
  }

  /** Resamples with bilinear filtering. */
  private Texels resampled(int newWidth, int newHeight) {
    if (newWidth == width && newHeight == height) {
      return this;
    }
    Texels resampled = new Texels(newWidth, newHeight);
    for (int y = 0; y < newHeight; y++) {
      double v = (y + 0.5) * height / newHeight - 0.5;
      for (int x = 0; x < newWidth; x++) {
        long sample = bilinear((x + 0.5) * width / newWidth - 0.5, v);
        resampled.texels[resampled.index(x, y)] = packed(sample);
      }
    }
    resampled.wrapEdges();
    return resampled;
  }

  private int index(int x, int y) {
    return y * (width + 1) + x;
  }

  private void wrapEdges() {
    for (int y = 0; y < height; y++) {
      texels[index(width, y)] = texels[index(0, y)];
    }
    System.arraycopy(texels, 0, texels, index(0, height), width + 1);
  }

  /** Returns a bilinear sample, clamped to the edges. */
  private long bilinear(double u, double v) {
    int x = (int) Math.floor(u);
    int y = (int) Math.floor(v);
    int right = (int) ((u - x) * 256);
    int down = (int) ((v - y) * 256);
    long above = lerp(clamped(x, y), clamped(x + 1, y), right);
    long below = lerp(clamped(x, y + 1), clamped(x + 1, y + 1), right);
    return lerp(above, below, down);
  }

  private long clamped(int x, int y) {
    return texel(index(Math.max(0, Math.min(width - 1, x)), Math.max(0, Math.min(height - 1, y))));
  }

  private long texel(int index) {
    return unpacked(texels[index]);
  }

  private static long unpacked(int texel) {
    long low = texel & 0xffffffffL;
    return (low | (low << 24)) & MASK;
  }

  private static int packed(long channels) {
    return (int) (channels | (channels >>> 24));
  }

  private static long lerp(long from, long to, int weight) {
    return divide256(from * (256 - weight) + to * weight + HALF);
  }

  private static int premultiplied(int opaque, int alpha) {
    return packed(divide256(unpacked(opaque) * (alpha + (alpha >> 7)) + HALF));
  }

  private static long divide256(long channels) {
    return (channels >>> 8) & MASK;
  }

  private static int ceilingPowerOfTwo(int size) {
    return size == 1 ? 1 : 2 * Integer.highestOneBit(size - 1);
  }
}
