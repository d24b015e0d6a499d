package tellosimulator.video.camera;

import java.util.Arrays;

/**
 * What a software camera draws on: packed pixels row by row from the top, and how near each is. It
 * is used again and again. For one thread at a time.
 */
public final class Raster {

  private final int width;
  private final int height;
  private final int[] pixels;
  private final float[] nearness;

  public Raster(int width, int height) {
    this.width = width;
    this.height = height;
    pixels = new int[width * height];
    nearness = new float[width * height];
  }

  public int width() {
    return width;
  }

  public int height() {
    return height;
  }

  /** The pixels themselves, not a copy; packed as {@link ColorSpace} says. */
  public int[] pixels() {
    return pixels;
  }

  /** For each pixel 1 divided by its distance along the camera's axis [1/m]; 0 is nothing. */
  float[] nearness() {
    return nearness;
  }

  /**
   * Copies the pixels for a screen: opaque where something was drawn, and nothing elsewhere. Of
   * {@link ColorSpace#RGB}.
   *
   * @param argb gets as many pixels
   */
  public void copyTo(int[] argb) {
    for (int i = 0; i < argb.length; i++) {
      argb[i] = nearness[i] > 0 ? pixels[i] | 0xff000000 : 0;
    }
  }

  /** Takes everything out of the picture. */
  void clear(int packed) {
    Arrays.fill(pixels, packed);
    Arrays.fill(nearness, 0);
  }
}
