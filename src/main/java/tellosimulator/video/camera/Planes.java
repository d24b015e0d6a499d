package tellosimulator.video.camera;

import java.util.Arrays;
import tellosimulator.video.picture.Picture;

/** Writes pixels of {@link ColorSpace#YUV} into the planes of a picture. */
final class Planes {

  /** The first and the second colour channel of a packed pixel. */
  private static final int COLORS = 0x00ff00ff;

  /** No colour. */
  private static final byte NEUTRAL = (byte) 128;

  private static final int TWO = 0x00020002;

  private Planes() {}

  /**
   * Fills a picture of the raster's size. The colour of four pixels is their mean.
   *
   * @param raster is only read
   */
  static void write(Raster raster, Picture picture) {
    int[] pixels = raster.pixels();
    byte[] luma = picture.y();
    byte[] us = picture.u();
    byte[] vs = picture.v();
    int width = raster.width();
    for (int y = 0; y < raster.height(); y += 2) {
      int color = y / 2 * (width / 2);
      int above = y * width;
      for (int i = above; i < above + width; i += 2, color++) {
        int a = pixels[i];
        int b = pixels[i + 1];
        int c = pixels[i + width];
        int d = pixels[i + width + 1];
        luma[i] = (byte) (a >> 8);
        luma[i + 1] = (byte) (b >> 8);
        luma[i + width] = (byte) (c >> 8);
        luma[i + width + 1] = (byte) (d >> 8);
        int sum = (a & COLORS) + (b & COLORS) + (c & COLORS) + (d & COLORS) + TWO;
        us[color] = (byte) (sum >> 18);
        vs[color] = (byte) (sum >> 2);
      }
    }
  }

  /**
   * Fills the upper part of a picture without colour, and the rest with zeros, which is green.
   *
   * @param raster as wide as the picture and at most as high; is only read
   */
  static void writeGrey(Raster raster, Picture picture) {
    int[] pixels = raster.pixels();
    byte[] luma = picture.y();
    for (int i = 0; i < pixels.length; i++) {
      luma[i] = (byte) (pixels[i] >> 8);
    }
    Arrays.fill(luma, pixels.length, luma.length, (byte) 0);
    for (byte[] color : new byte[][] {picture.u(), picture.v()}) {
      Arrays.fill(color, 0, pixels.length / 4, NEUTRAL);
      Arrays.fill(color, pixels.length / 4, color.length, (byte) 0);
    }
  }
}
