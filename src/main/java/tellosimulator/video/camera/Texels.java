package tellosimulator.video.camera;

import tellosimulator.scenery.Texture;

/**
 * The pixels of a texture in some size and colour space, on their way to {@link Quads}. It has its
 * first column and row once more behind its last, so that neighbours need no thought where it
 * repeats. Immutable; for any thread.
 */
final class Texels {

  private static final long HALF = 0x0080008000800080L;
  private static final long TWO = 0x0002000200020002L;

  private final int width;
  private final int height;

  /** {@link Lanes}, row by row, with a column and a row more. */
  private final long[] texels;

  private Texels(int width, int height) {
    this.width = width;
    this.height = height;
    texels = new long[(width + 1) * (height + 1)];
  }

  /**
   * A texture in its own size.
   *
   * @param masked whether opacity counts; colours are then multiplied with it
   */
  static Texels of(Texture texture, ColorSpace space, boolean masked) {
    Texels made = new Texels(texture.width(), texture.height());
    int[] argb = texture.argbArray();
    for (int y = 0; y < made.height; y++) {
      int to = made.index(0, y);
      for (int i = y * made.width; i < (y + 1) * made.width; i++, to++) {
        long opaque = Lanes.of(space.of(argb[i] | 0xff000000));
        made.texels[to] = masked ? faded(opaque, argb[i] >>> 24) : opaque;
      }
    }
    made.closeEdges();
    return made;
  }

  int width() {
    return width;
  }

  int height() {
    return height;
  }

  /**
   * One channel of all.
   *
   * @param shift where it is in {@link Lanes}
   */
  Quads channel(int shift) {
    int[] quads = new int[Quads.size(width, height)];
    for (int y = 0; y < height; y++) {
      int at = index(0, y);
      int left = column(at, shift);
      for (int x = 0; x < width; x++) {
        at++;
        int right = column(at, shift);
        quads[Quads.index(x, y, width)] = left | (right << 8);
        left = right;
      }
    }
    return new Quads(width, height, quads);
  }

  /** A pixel in the lowest 8 bits, and the one below it 16 bits higher. */
  private int column(int at, int shift) {
    int upper = (int) (texels[at] >>> shift) & 255;
    int lower = (int) (texels[at + width + 1] >>> shift) & 255;
    return upper | (lower << 16);
  }

  /** Half as large; a side of one pixel stays. Each pixel is the mean of four. */
  Texels halved() {
    Texels half = new Texels(Math.max(1, width / 2), Math.max(1, height / 2));
    int right = width > 1 ? 1 : 0;
    int below = height > 1 ? width + 1 : 0;
    for (int y = 0; y < half.height; y++) {
      for (int x = 0; x < half.width; x++) {
        int i = index(right == 0 ? 0 : 2 * x, below == 0 ? 0 : 2 * y);
        long sum = texels[i] + texels[i + right] + texels[i + below] + texels[i + below + right];
        half.texels[half.index(x, y)] = ((sum + TWO) >>> 2) & Lanes.MASK;
      }
    }
    half.closeEdges();
    return half;
  }

  /**
   * The same, each side the next power of two and not longer than a limit.
   *
   * @param largest a power of two
   */
  Texels squared(int largest) {
    Texels small = this;
    while (small.width > 2 * largest || small.height > 2 * largest) {
      small = small.halved();
    }
    return small.stretched(
        Math.min(largest, powerOfTwo(small.width)), Math.min(largest, powerOfTwo(small.height)));
  }

  /** Of another size; pixels in between are mixed of their neighbours. */
  private Texels stretched(int newWidth, int newHeight) {
    if (newWidth == width && newHeight == height) {
      return this;
    }
    Texels stretched = new Texels(newWidth, newHeight);
    for (int y = 0; y < newHeight; y++) {
      double v = (y + 0.5) * height / newHeight - 0.5;
      for (int x = 0; x < newWidth; x++) {
        stretched.texels[stretched.index(x, y)] = mixed((x + 0.5) * width / newWidth - 0.5, v);
      }
    }
    stretched.closeEdges();
    return stretched;
  }

  private int index(int x, int y) {
    return y * (width + 1) + x;
  }

  private void closeEdges() {
    for (int y = 0; y < height; y++) {
      texels[index(width, y)] = texels[index(0, y)];
    }
    System.arraycopy(texels, 0, texels, index(0, height), width + 1);
  }

  /** Beyond its edges the texture goes on as it is at them. */
  private long mixed(double u, double v) {
    int x = (int) Math.floor(u);
    int y = (int) Math.floor(v);
    int right = (int) ((u - x) * 256);
    int down = (int) ((v - y) * 256);
    long above = mixed(within(x, y), within(x + 1, y), right);
    long below = mixed(within(x, y + 1), within(x + 1, y + 1), right);
    return mixed(above, below, down);
  }

  private long within(int x, int y) {
    return texels[index(Math.max(0, Math.min(width - 1, x)), Math.max(0, Math.min(height - 1, y)))];
  }

  private static long mixed(long from, long to, int weight) {
    return Lanes.mean(from * (256 - weight) + to * weight + HALF);
  }

  private static long faded(long opaque, int opacity) {
    return Lanes.mean(opaque * (opacity + (opacity >> 7)) + HALF);
  }

  private static int powerOfTwo(int size) {
    return size == 1 ? 1 : 2 * Integer.highestOneBit(size - 1);
  }
}
