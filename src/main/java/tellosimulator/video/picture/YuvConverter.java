package tellosimulator.video.picture;

/**
 * Converts pictures from Y'CbCr (ITU-R BT.601, luma from 16 to 235) to opaque ARGB with 8 bits for
 * each component. Thread-safe.
 */
public final class YuvConverter {

  /** Number of fractional bits in the factors. */
  private static final int PLACES = 16;

  private static final int HALF = 1 << (PLACES - 1);

  /** Scale factor for luma: 255 / 219. */
  private static final int LUMA = fixed(255 / 219.0);

  /** Factor from Cr to red: 2 (1 - 0.299) 255 / 224. Documented: ITU-R BT.601-7, 2.5. */
  private static final int RED = fixed(1.402 * 255 / 224);

  /** Factor from Cb to blue: 2 (1 - 0.114) 255 / 224. */
  private static final int BLUE = fixed(1.772 * 255 / 224);

  /** Factor from Cb to green: 0.114 / 0.587 times the factor to blue. */
  private static final int GREEN_OF_U = fixed(1.772 * 255 / 224 * 0.114 / 0.587);

  /** Factor from Cr to green: 0.299 / 0.587 times the factor to red. */
  private static final int GREEN_OF_V = fixed(1.402 * 255 / 224 * 0.299 / 0.587);

  private YuvConverter() {}

  /**
   * Converts all pixels.
   *
   * @param argb receives the pixels row by row
   */
  public static void whole(Picture picture, int[] argb) {
    byte[] luma = picture.y();
    int width = picture.width();
    for (int row = 0; row < picture.height(); row += 2) {
      int color = row / 2 * (width / 2);
      for (int i = row * width; i < (row + 1) * width; i += 2, color++) {
        int u = (picture.u()[color] & 255) - 128;
        int v = (picture.v()[color] & 255) - 128;
        int red = RED * v + HALF;
        int green = HALF - GREEN_OF_U * u - GREEN_OF_V * v;
        int blue = BLUE * u + HALF;
        argb[i] = pixel((luma[i] & 255) - 16, red, green, blue);
        argb[i + 1] = pixel((luma[i + 1] & 255) - 16, red, green, blue);
        argb[i + width] = pixel((luma[i + width] & 255) - 16, red, green, blue);
        argb[i + width + 1] = pixel((luma[i + width + 1] & 255) - 16, red, green, blue);
      }
    }
  }

  /**
   * Converts to half the width and height; each pixel is the mean of four. This is a quarter of the
   * work, and looks better than if pixels were dropped when the picture is scaled on the screen.
   *
   * @param argb receives the pixels row by row
   */
  public static void half(Picture picture, int[] argb) {
    byte[] luma = picture.y();
    int width = picture.width();
    for (int row = 0; row < picture.height(); row += 2) {
      int color = row / 2 * (width / 2);
      for (int i = row * width; i < (row + 1) * width; i += 2, color++) {
        int u = (picture.u()[color] & 255) - 128;
        int v = (picture.v()[color] & 255) - 128;
        int sum =
            (luma[i] & 255)
                + (luma[i + 1] & 255)
                + (luma[i + width] & 255)
                + (luma[i + width + 1] & 255);
        argb[color] =
            pixel(
                ((sum + 2) >> 2) - 16,
                RED * v + HALF,
                HALF - GREEN_OF_U * u - GREEN_OF_V * v,
                BLUE * u + HALF);
      }
    }
  }

  /**
   * Returns an ARGB pixel. Takes four numbers, because an object for each pixel would cost more
   * than the conversion.
   */
  private static int pixel(int brightness, int red, int green, int blue) {
    int light = LUMA * brightness;
    return 255 << 24
        | clamped((light + red) >> PLACES) << 16
        | clamped((light + green) >> PLACES) << 8
        | clamped((light + blue) >> PLACES);
  }

  private static int clamped(int value) {
    return (value & ~255) == 0 ? value : value < 0 ? 0 : 255;
  }

  private static int fixed(double factor) {
    return (int) Math.round(factor * (1 << PLACES));
  }
}
