package tellosimulator.video.codec;

import java.util.Arrays;

/**
 * A sample plane of a {@link Frame}. It consists of unsigned bytes, row by row, with a border on
 * all four sides into which motion vectors may point.
 */
final class Plane {

  /** Padding at the end [bytes]. Loading eight bytes at once may read beyond the last sample. */
  private static final int SLACK = 16;

  final byte[] bytes;
  final int stride;
  final int width;
  final int height;
  private final int border;

  /**
   * Creates a plane.
   *
   * @param width a multiple of 8
   * @param border number of samples beyond each edge
   */
  Plane(int width, int height, int border) {
    this.width = width;
    this.height = height;
    this.border = border;
    stride = width + 2 * border;
    bytes = new byte[stride * (height + 2 * border) + SLACK];
  }

  /** Returns the offset of a sample in {@link #bytes}. */
  int offset(int x, int y) {
    return (y + border) * stride + border + x;
  }

  /**
   * Loads a picture that may be smaller than this plane, and pads it by repeating its last column
   * and row.
   */
  void load(byte[] samples, int sampleWidth) {
    int rows = samples.length / sampleWidth;
    for (int y = 0; y < height; y++) {
      int row = offset(0, y);
      int from = Math.min(y, rows - 1) * sampleWidth;
      System.arraycopy(samples, from, bytes, row, sampleWidth);
      if (sampleWidth < width) {
        Arrays.fill(bytes, row + sampleWidth, row + width, samples[from + sampleWidth - 1]);
      }
    }
  }

  /**
   * Fills the border with the nearest samples, as required for unrestricted motion vectors (H.264,
   * 8.4.2.2.1).
   */
  void expandBorders() {
    for (int y = 0; y < height; y++) {
      int row = offset(0, y);
      Arrays.fill(bytes, row - border, row, bytes[row]);
      Arrays.fill(bytes, row + width, row + width + border, bytes[row + width - 1]);
    }
    int first = offset(-border, 0);
    int last = offset(-border, height - 1);
    for (int row = 1; row <= border; row++) {
      System.arraycopy(bytes, first, bytes, first - row * stride, stride);
      System.arraycopy(bytes, last, bytes, last + row * stride, stride);
    }
  }
}
