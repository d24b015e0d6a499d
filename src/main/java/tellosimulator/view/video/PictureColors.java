package tellosimulator.view.video;

import tellosimulator.video.picture.Picture;

/**
 * Makes the colours of a {@link Picture} (ITU-R BT.601, brightness from 16 to 235) from those of a
 * screen. For any thread.
 */
final class PictureColors {

  /** Binary places of the factors. */
  private static final int PLACES = 16;

  /** Red, green and blue of the brightness. Documented: ITU-R BT.601-7, 2.5. */
  private static final int Y_RED = fixed(0.299 * 219 / 255);

  private static final int Y_GREEN = fixed(0.587 * 219 / 255);
  private static final int Y_BLUE = fixed(0.114 * 219 / 255);

  /** Of the blue difference, (blue - brightness) / 1.772, which has 224 steps. */
  private static final int U_RED = fixed(-0.299 / 1.772 * 224 / 255);

  private static final int U_GREEN = fixed(-0.587 / 1.772 * 224 / 255);
  private static final int U_BLUE = fixed(0.5 * 224 / 255);

  /** Of the red difference, (red - brightness) / 1.402. */
  private static final int V_RED = fixed(0.5 * 224 / 255);

  private static final int V_GREEN = fixed(-0.587 / 1.402 * 224 / 255);
  private static final int V_BLUE = fixed(-0.114 / 1.402 * 224 / 255);

  private static final int DARKEST = (16 << PLACES) + (1 << (PLACES - 1));

  /** No colour; the sum of four pixels has two binary places more. */
  private static final int NEUTRAL = (128 << (PLACES + 2)) + (1 << (PLACES + 1));

  private PictureColors() {}

  /**
   * Fills a picture; the colour of four pixels is their mean.
   *
   * @param argb as many pixels, row by row, opaque
   */
  static void fill(Picture picture, int[] argb) {
    byte[] luma = picture.y();
    int width = picture.width();
    for (int row = 0; row < picture.height(); row += 2) {
      int color = row / 2 * (width / 2);
      for (int i = row * width; i < (row + 1) * width; i += 2, color++) {
        int a = argb[i];
        int b = argb[i + 1];
        int c = argb[i + width];
        int d = argb[i + width + 1];
        luma[i] = brightness(a);
        luma[i + 1] = brightness(b);
        luma[i + width] = brightness(c);
        luma[i + width + 1] = brightness(d);
        int red = (a >> 16 & 255) + (b >> 16 & 255) + (c >> 16 & 255) + (d >> 16 & 255);
        int green = (a >> 8 & 255) + (b >> 8 & 255) + (c >> 8 & 255) + (d >> 8 & 255);
        int blue = (a & 255) + (b & 255) + (c & 255) + (d & 255);
        picture.u()[color] =
            (byte) ((NEUTRAL + U_RED * red + U_GREEN * green + U_BLUE * blue) >> (PLACES + 2));
        picture.v()[color] =
            (byte) ((NEUTRAL + V_RED * red + V_GREEN * green + V_BLUE * blue) >> (PLACES + 2));
      }
    }
  }

  private static byte brightness(int argb) {
    return (byte)
        ((DARKEST
                + Y_RED * (argb >> 16 & 255)
                + Y_GREEN * (argb >> 8 & 255)
                + Y_BLUE * (argb & 255))
            >> PLACES);
  }

  private static int fixed(double factor) {
    return (int) Math.round(factor * (1 << PLACES));
  }
}
