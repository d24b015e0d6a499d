package tellosimulator.video.camera;

import java.util.Arrays;
import tellosimulator.video.picture.Picture;

/**
 * What a software camera draws on: a plane for each channel of a colour space, row by row from the
 * top, and how near each pixel is. It is used again and again. For one thread at a time.
 *
 * <p>It knows which part of each row has been drawn on: beside it nothing can hide what is drawn,
 * which most of a picture need not ask then.
 *
 * <p>Each loop over pixels is a method of its own: so the compiler has least to do, which counts
 * while the first picture is drawn.
 */
public final class Raster {

  private final int width;
  private final int height;
  private final ColorSpace space;
  private final float[] nearness;

  /** 0, 1, 2 and so on. */
  private final float[] steps;

  private final int[] drawnFrom;
  private final int[] drawnTo;
  private byte[] first = new byte[0];
  private byte[] second = new byte[0];
  private byte[] third = new byte[0];

  private Raster(int width, int height, ColorSpace space) {
    this.width = width;
    this.height = height;
    this.space = space;
    nearness = new float[width * height];
    steps = new float[width];
    for (int i = 0; i < width; i++) {
      steps[i] = i;
    }
    drawnFrom = new int[height];
    drawnTo = new int[height];
  }

  /** One for a screen, in {@link ColorSpace#RGB}. */
  public static Raster forScreen(int width, int height) {
    Raster raster = new Raster(width, height, ColorSpace.RGB);
    raster.first = new byte[width * height];
    raster.second = new byte[width * height];
    raster.third = new byte[width * height];
    return raster;
  }

  /**
   * One that draws on the upper part of a picture, in {@link ColorSpace#YUV}.
   *
   * @param height of this part in pixels, even
   */
  public static Raster on(Picture picture, int height) {
    Raster raster = new Raster(picture.width(), height, ColorSpace.YUV);
    raster.first = picture.y();
    raster.second = picture.u();
    raster.third = picture.v();
    return raster;
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

  /** Whether it draws on just that part of just that picture. */
  boolean isOn(Picture picture, int rows) {
    return first == picture.y() && height == rows;
  }

  /**
   * Copies the pixels for a screen: opaque where something was drawn, and nothing elsewhere. Of
   * {@link ColorSpace#RGB}.
   *
   * @param argb gets as many pixels
   */
  public void copyTo(int[] argb) {
    for (int i = 0; i < argb.length; i++) {
      argb[i] = nearness[i] > 0 ? argb(i) : 0;
    }
  }

  /** A pixel, row by row, opaque; of {@link ColorSpace#RGB}. */
  int argb(int i) {
    return 0xff000000 | (first[i] & 255) << 16 | (second[i] & 255) << 8 | (third[i] & 255);
  }

  /** Takes everything out of the picture: it becomes black. */
  void clear() {
    int black = space.black();
    int colors = space.coarse() ? width * height / 4 : width * height;
    Arrays.fill(first, 0, width * height, (byte) (black >> 16));
    Arrays.fill(second, 0, colors, (byte) (black >> 8));
    Arrays.fill(third, 0, colors, (byte) black);
    Arrays.fill(nearness, 0);
    Arrays.fill(drawnFrom, width);
    Arrays.fill(drawnTo, 0);
  }

  /**
   * Draws a part of a row, where nothing nearer is.
   *
   * @param near 1 divided by the distance of the first pixel along the camera's axis [1/m]
   * @param step by how much that grows with each pixel
   */
  void draw(int row, Strip strip, float near, float step) {
    int from = strip.from;
    int to = from + strip.count;
    int overlap = Math.min(Math.max(from, drawnFrom[row]), to);
    int beyond = Math.max(Math.min(to, drawnTo[row]), overlap);
    cover(row, from, overlap, strip, near, step);
    compare(row, overlap, beyond, strip, near, step);
    cover(row, beyond, to, strip, near, step);
    drawnFrom[row] = Math.min(drawnFrom[row], from);
    drawnTo[row] = Math.max(drawnTo[row], to);
  }

  /** Draws pixels that nothing hides. */
  private void cover(int row, int from, int to, Strip strip, float near, float step) {
    if (from >= to) {
      return;
    }
    int at = row * width + from;
    int skip = from - strip.from;
    approach(at, skip, to - from, near, step);
    copy(strip.first, skip, first, at, to - from);
    if (!space.coarse()) {
      copy(strip.second, skip, second, at, to - from);
      copy(strip.third, skip, third, at, to - from);
    } else if (row % 2 == 0) {
      int column = (from + 1) / 2;
      int colors = (to + 1) / 2 - column;
      int skipped = column - (strip.from + 1) / 2;
      copy(strip.second, skipped, second, colorRow(row) + column, colors);
      copy(strip.third, skipped, third, colorRow(row) + column, colors);
    }
  }

  private void approach(int at, int skip, int count, float near, float step) {
    for (int i = 0; i < count; i++) {
      nearness[at + i] = near + step * steps[skip + i];
    }
  }

  private static void copy(int[] values, int skip, byte[] plane, int at, int count) {
    for (int i = 0; i < count; i++) {
      plane[at + i] = (byte) values[skip + i];
    }
  }

  /** Draws pixels where nothing nearer is. */
  private void compare(int row, int from, int to, Strip strip, float near, float step) {
    int start = row * width;
    if (space.coarse() && row % 2 == 0) { // before nearness changes
      int last = (strip.from + 1) / 2;
      for (int column = (from + 1) / 2; column < (to + 1) / 2; column++) {
        int i = 2 * column;
        if (near + step * steps[i - strip.from] > nearness[start + i]) {
          second[colorRow(row) + column] = (byte) strip.second[column - last];
          third[colorRow(row) + column] = (byte) strip.third[column - last];
        }
      }
    }
    for (int i = from; i < to; i++) {
      int number = i - strip.from;
      float nearHere = near + step * steps[number];
      if (nearHere > nearness[start + i]) {
        nearness[start + i] = nearHere;
        first[start + i] = (byte) strip.first[number];
        if (!space.coarse()) {
          second[start + i] = (byte) strip.second[number];
          third[start + i] = (byte) strip.third[number];
        }
      }
    }
  }

  /**
   * Draws a translucent part of a row over what is there, where nothing nearer is. Of its channels,
   * each is multiplied with the opacity.
   *
   * @param share of its opacity that counts, 0 to 256
   */
  void blend(int row, Strip strip, float near, float step, int share) {
    int at = row * width + strip.from;
    int[] shares = strip.shares;
    share(at, strip.count, near, step, share, shares);
    blend(strip.first, strip.opacity, shares, first, at, strip.count);
    if (!space.coarse()) {
      blend(strip.second, strip.colorOpacity, shares, second, at, strip.count);
      blend(strip.third, strip.colorOpacity, shares, third, at, strip.count);
    } else if (row % 2 == 0) {
      int count = strip.evenCount();
      int color = colorRow(row) + (strip.from + 1) / 2;
      strip.halveShares();
      blend(strip.second, strip.colorOpacity, shares, second, color, count);
      blend(strip.third, strip.colorOpacity, shares, third, color, count);
    }
  }

  /** How much counts of what is to be blended: nothing of what is hidden. */
  private void share(int at, int count, float near, float step, int share, int[] shares) {
    for (int i = 0; i < count; i++) {
      shares[i] = near + step * steps[i] >= nearness[at + i] ? share : 0;
    }
  }

  private static void blend(
      int[] values, int[] opacity, int[] shares, byte[] plane, int at, int count) {
    for (int i = 0; i < count; i++) {
      int share = shares[i];
      if (share > 0) {
        int covered = (opacity[i] * share) >> 8;
        int under = ((plane[at + i] & 255) * (256 - covered - (covered >> 7))) >> 8;
        plane[at + i] = (byte) (under + ((values[i] * share) >> 8));
      }
    }
  }

  private int colorRow(int row) {
    return row / 2 * (width / 2);
  }
}
