package tellosimulator.video.codec;

import java.util.Arrays;

/**
 * One of the three planes of a {@link Frame}: bytes without sign, row by row, with a border on all
 * four sides into which motion vectors may point.
 */
final class Plane {

  /** Whoever reads eight bytes at once may read that far beyond the last pixel. */
  private static final int SLACK = 16;

  final byte[] bytes;
  final int stride;
  final int width;
  final int height;
  private final int border;

  /**
   * @param width a multiple of 8
   * @param border pixels beyond each edge
   */
  Plane(int width, int height, int border) {
    this.width = width;
    this.height = height;
    this.border = border;
    stride = width + 2 * border;
    bytes = new byte[stride * (height + 2 * border) + SLACK];
  }

  /** Where a pixel is in {@link #bytes}. */
  int at(int x, int y) {
    return (y + border) * stride + border + x;
  }

  /** Takes a smaller picture over and repeats its last column and row up to this plane's size. */
  void load(byte[] pixels, int pixelWidth) {
    int rows = pixels.length / pixelWidth;
    for (int y = 0; y < height; y++) {
      int row = at(0, y);
      int from = Math.min(y, rows - 1) * pixelWidth;
      System.arraycopy(pixels, from, bytes, row, pixelWidth);
      if (pixelWidth < width) {
        Arrays.fill(bytes, row + pixelWidth, row + width, pixels[from + pixelWidth - 1]);
      }
    }
  }

  /** Repeats the pixels at the edges into the border. */
  void extend() {
    for (int y = 0; y < height; y++) {
      int row = at(0, y);
      Arrays.fill(bytes, row - border, row, bytes[row]);
      Arrays.fill(bytes, row + width, row + width + border, bytes[row + width - 1]);
    }
    int first = at(-border, 0);
    int last = at(-border, height - 1);
    for (int row = 1; row <= border; row++) {
      System.arraycopy(bytes, first, bytes, first - row * stride, stride);
      System.arraycopy(bytes, last, bytes, last + row * stride, stride);
    }
  }
}
