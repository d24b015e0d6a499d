package tellosimulator.video.camera;

import java.util.Arrays;
import tellosimulator.video.picture.Picture;

/**
 * A frame buffer. It consists of a depth buffer of 1/z, and of one plane for each channel of a
 * colour space. All of them are stored row by row from the top. Reused for each frame, by one
 * thread at a time.
 *
 * <p>The frame buffer tracks the covered interval of each row. Outside this interval no pixel can
 * be hidden, so most of a frame needs no depth test.
 *
 * <p>Each loop over pixels is a separate method, which minimises just-in-time compilation. This
 * matters while the first frame is rendered.
 */
public final class FrameBuffer {

  private final int width;
  private final int height;
  private final ColorSpace space;

  /** 1/z of each pixel [1/m]; 0 where nothing is drawn. */
  private final float[] depth;

  /** The numbers 0, 1, 2 and so on. */
  private final float[] ramp;

  private final int[] coveredFrom;
  private final int[] coveredTo;
  private byte[] first = new byte[0];
  private byte[] second = new byte[0];
  private byte[] third = new byte[0];

  private FrameBuffer(int width, int height, ColorSpace space) {
    this.width = width;
    this.height = height;
    this.space = space;
    depth = new float[width * height];
    ramp = new float[width];
    for (int i = 0; i < width; i++) {
      ramp[i] = i;
    }
    coveredFrom = new int[height];
    coveredTo = new int[height];
  }

  /** Creates a frame buffer for a screen, in {@link ColorSpace#RGB}. */
  public static FrameBuffer forScreen(int width, int height) {
    FrameBuffer frameBuffer = new FrameBuffer(width, height, ColorSpace.RGB);
    frameBuffer.first = new byte[width * height];
    frameBuffer.second = new byte[width * height];
    frameBuffer.third = new byte[width * height];
    return frameBuffer;
  }

  /**
   * Creates a frame buffer that writes through to the upper part of a picture, in {@link
   * ColorSpace#YUV}.
   *
   * @param height height of that part [pixels], even
   */
  static FrameBuffer on(Picture picture, int height) {
    FrameBuffer frameBuffer = new FrameBuffer(picture.width(), height, ColorSpace.YUV);
    frameBuffer.first = picture.y();
    frameBuffer.second = picture.u();
    frameBuffer.third = picture.v();
    return frameBuffer;
  }

  public int width() {
    return width;
  }

  public int height() {
    return height;
  }

  ColorSpace space() {
    return space;
  }

  /** Returns whether this frame buffer writes through to exactly these rows of a picture. */
  boolean isOn(Picture picture, int rows) {
    return first == picture.y() && height == rows;
  }

  /**
   * Copies the pixels for a screen. They are opaque where something was drawn, and transparent
   * elsewhere. Requires {@link ColorSpace#RGB}.
   *
   * @param argb receives all pixels
   */
  public void copyTo(int[] argb) {
    for (int i = 0; i < argb.length; i++) {
      argb[i] = depth[i] > 0 ? argb(i) : 0;
    }
  }

  /**
   * Returns a pixel as opaque ARGB. Requires {@link ColorSpace#RGB}.
   *
   * @param i the index of the pixel in row order
   */
  int argb(int i) {
    return 0xff000000 | (first[i] & 255) << 16 | (second[i] & 255) << 8 | (third[i] & 255);
  }

  /** Clears all pixels to black and all depths to infinity. */
  void clear() {
    int black = space.black();
    int chromaSize = space.subsampled() ? width * height / 4 : width * height;
    Arrays.fill(first, 0, width * height, (byte) (black >> 16));
    Arrays.fill(second, 0, chromaSize, (byte) (black >> 8));
    Arrays.fill(third, 0, chromaSize, (byte) black);
    Arrays.fill(depth, 0);
    Arrays.fill(coveredFrom, width);
    Arrays.fill(coveredTo, 0);
  }

  /**
   * Draws an opaque span with a depth test.
   *
   * @param invZ 1/z of the first pixel [1/m]
   * @param invZdx derivative of 1/z with respect to x
   */
  void draw(int row, Span span, float invZ, float invZdx) {
    int from = span.x;
    int to = from + span.count;
    int testFrom = Math.min(Math.max(from, coveredFrom[row]), to);
    int testTo = Math.max(Math.min(to, coveredTo[row]), testFrom);
    overwrite(row, from, testFrom, span, invZ, invZdx);
    test(row, testFrom, testTo, span, invZ, invZdx);
    overwrite(row, testTo, to, span, invZ, invZdx);
    coveredFrom[row] = Math.min(coveredFrom[row], from);
    coveredTo[row] = Math.max(coveredTo[row], to);
  }

  /** Writes pixels without a depth test. */
  private void overwrite(int row, int from, int to, Span span, float invZ, float invZdx) {
    if (from >= to) {
      return;
    }
    int at = row * width + from;
    int skip = from - span.x;
    writeDepth(at, skip, to - from, invZ, invZdx);
    copy(span.first, skip, first, at, to - from);
    if (!space.subsampled()) {
      copy(span.second, skip, second, at, to - from);
      copy(span.third, skip, third, at, to - from);
    } else if (row % 2 == 0) {
      int column = (from + 1) / 2;
      int count = (to + 1) / 2 - column;
      int chromaSkip = column - (span.x + 1) / 2;
      copy(span.second, chromaSkip, second, chromaRow(row) + column, count);
      copy(span.third, chromaSkip, third, chromaRow(row) + column, count);
    }
  }

  private void writeDepth(int at, int skip, int count, float invZ, float invZdx) {
    for (int i = 0; i < count; i++) {
      depth[at + i] = invZ + invZdx * ramp[skip + i];
    }
  }

  private static void copy(int[] values, int skip, byte[] plane, int at, int count) {
    for (int i = 0; i < count; i++) {
      plane[at + i] = (byte) values[skip + i];
    }
  }

  /** Writes the pixels that pass the depth test. */
  private void test(int row, int from, int to, Span span, float invZ, float invZdx) {
    int start = row * width;
    if (space.subsampled() && row % 2 == 0) { // before the depth buffer changes
      int last = (span.x + 1) / 2;
      for (int column = (from + 1) / 2; column < (to + 1) / 2; column++) {
        int i = 2 * column;
        if (invZ + invZdx * ramp[i - span.x] > depth[start + i]) {
          second[chromaRow(row) + column] = (byte) span.second[column - last];
          third[chromaRow(row) + column] = (byte) span.third[column - last];
        }
      }
    }
    for (int i = from; i < to; i++) {
      int index = i - span.x;
      float pixelDepth = invZ + invZdx * ramp[index];
      if (pixelDepth > depth[start + i]) {
        depth[start + i] = pixelDepth;
        first[start + i] = (byte) span.first[index];
        if (!space.subsampled()) {
          second[start + i] = (byte) span.second[index];
          third[start + i] = (byte) span.third[index];
        }
      }
    }
  }

  /**
   * Blends a translucent span with premultiplied alpha over those pixels where the span passes the
   * depth test. The depth buffer is not changed.
   *
   * @param opacity opacity of the whole span, 0 to 256
   */
  void blend(int row, Span span, float invZ, float invZdx, int opacity) {
    int at = row * width + span.x;
    int[] coverage = span.coverage;
    cover(at, span.count, invZ, invZdx, opacity, coverage);
    blend(span.first, span.alpha, coverage, first, at, span.count);
    if (!space.subsampled()) {
      blend(span.second, span.chromaAlpha, coverage, second, at, span.count);
      blend(span.third, span.chromaAlpha, coverage, third, at, span.count);
    } else if (row % 2 == 0) {
      int count = span.evenCount();
      int chromaAt = chromaRow(row) + (span.x + 1) / 2;
      span.subsampleCoverage();
      blend(span.second, span.chromaAlpha, coverage, second, chromaAt, count);
      blend(span.third, span.chromaAlpha, coverage, third, chromaAt, count);
    }
  }

  /** Computes the opacity of each pixel; it is zero where the pixel fails the depth test. */
  private void cover(int at, int count, float invZ, float invZdx, int opacity, int[] coverage) {
    for (int i = 0; i < count; i++) {
      coverage[i] = invZ + invZdx * ramp[i] >= depth[at + i] ? opacity : 0;
    }
  }

  private static void blend(
      int[] values, int[] alpha, int[] coverage, byte[] plane, int at, int count) {
    for (int i = 0; i < count; i++) {
      int covered = coverage[i];
      if (covered > 0) {
        int effective = (alpha[i] * covered) >> 8;
        int below = ((plane[at + i] & 255) * (256 - effective - (effective >> 7))) >> 8;
        plane[at + i] = (byte) (below + ((values[i] * covered) >> 8));
      }
    }
  }

  private int chromaRow(int row) {
    return row / 2 * (width / 2);
  }
}
