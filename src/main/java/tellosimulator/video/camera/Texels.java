package tellosimulator.video.camera;

import tellosimulator.scenery.Texture;

/** A texture while it is being prepared. */
final class Texels {

  private static final long HALF = 0x0080008000800080L;
  private static final long TWO = 0x0002000200020002L;

  private final int width;
  private final int height;
  private final long[] lanes;

  private Texels(int width, int height, long[] lanes) {
    this.width = width;
    this.height = height;
    this.lanes = lanes;
  }

  /**
   * @param masked whether opacity counts; colours are then multiplied with it
   */
  static Texels of(Texture texture, ColorSpace space, boolean masked) {
    int[] argb = texture.argbArray();
    long[] lanes = new long[argb.length];
    for (int i = 0; i < argb.length; i++) {
      lanes[i] = masked ? faded(argb[i], space) : Lanes.of(space.of(argb[i] | 0xff000000));
    }
    return new Texels(texture.width(), texture.height(), lanes);
  }

  int width() {
    return width;
  }

  int height() {
    return height;
  }

  /** The same, each side the next power of two and not longer than a limit. */
  Texels resized(int largest) {
    Texels small = this;
    while (small.width > 2 * largest || small.height > 2 * largest) {
      small = small.halved();
    }
    return small.stretched(
        Math.min(largest, powerOfTwo(small.width)), Math.min(largest, powerOfTwo(small.height)));
  }

  /** Half as large; a side of one pixel stays. Each pixel is the mean of four. */
  Texels halved() {
    int newWidth = Math.max(1, width / 2);
    int newHeight = Math.max(1, height / 2);
    int right = width > 1 ? 1 : 0;
    int below = height > 1 ? width : 0;
    long[] half = new long[newWidth * newHeight];
    for (int y = 0; y < newHeight; y++) {
      for (int x = 0; x < newWidth; x++) {
        int i = (height > 1 ? 2 * y : y) * width + (width > 1 ? 2 * x : x);
        long sum = lanes[i] + lanes[i + right] + lanes[i + below] + lanes[i + below + right];
        half[y * newWidth + x] = ((sum + TWO) >>> 2) & Lanes.MASK;
      }
    }
    return new Texels(newWidth, newHeight, half);
  }

  /** As it is drawn from. */
  MipMaps.Level level() {
    int stride = width + 1;
    long[] padded = new long[stride * (height + 1)];
    for (int y = 0; y <= height; y++) {
      System.arraycopy(lanes, y % height * width, padded, y * stride, width);
      padded[y * stride + width] = lanes[y % height * width];
    }
    return new MipMaps.Level(width, height, padded);
  }

  /** Of another size; pixels in between are mixed of their neighbours. */
  private Texels stretched(int newWidth, int newHeight) {
    if (newWidth == width && newHeight == height) {
      return this;
    }
    long[] stretched = new long[newWidth * newHeight];
    for (int y = 0; y < newHeight; y++) {
      double v = (y + 0.5) * height / newHeight - 0.5;
      for (int x = 0; x < newWidth; x++) {
        stretched[y * newWidth + x] = mixed((x + 0.5) * width / newWidth - 0.5, v);
      }
    }
    return new Texels(newWidth, newHeight, stretched);
  }

  /** Beyond its edges the texture goes on as it is at them. */
  private long mixed(double u, double v) {
    int x = (int) Math.floor(u);
    int y = (int) Math.floor(v);
    int right = (int) ((u - x) * 256);
    int down = (int) ((v - y) * 256);
    long above = mixed(at(x, y), at(x + 1, y), right);
    long below = mixed(at(x, y + 1), at(x + 1, y + 1), right);
    return mixed(above, below, down);
  }

  private static long mixed(long from, long to, int weight) {
    return Lanes.mean(from * (256 - weight) + to * weight + HALF);
  }

  private long at(int x, int y) {
    int inX = Math.max(0, Math.min(width - 1, x));
    int inY = Math.max(0, Math.min(height - 1, y));
    return lanes[inY * width + inX];
  }

  private static long faded(int argb, ColorSpace space) {
    int opacity = argb >>> 24;
    long full = Lanes.of(space.of(argb | 0xff000000));
    return Lanes.mean(full * (opacity + (opacity >> 7)) + HALF);
  }

  private static int powerOfTwo(int size) {
    return size == 1 ? 1 : 2 * Integer.highestOneBit(size - 1);
  }
}
