package tellosimulator.video.camera;

/**
 * What the three channels of a picture mean. A packed pixel has 8 bits each for opacity
 * (uppermost), first, second and third channel. Drawing works the same in both, because mixing
 * colours is.
 */
public enum ColorSpace {
  /** Red, green and blue; packed as a screen takes it. */
  RGB(false) {
    @Override
    int of(int argb) {
      return argb;
    }
  },

  /**
   * Brightness, blue difference and red difference after ITU-R BT.601, brightness from 16 to 235:
   * what decoders assume where a stream says nothing.
   */
  YUV(true) {
    @Override
    int of(int argb) {
      int red = (argb >> 16) & 255;
      int green = (argb >> 8) & 255;
      int blue = argb & 255;
      int y = (ROUNDED_16 + 16829 * red + 33039 * green + 6416 * blue) >> 16;
      int u = (ROUNDED_128 - 9714 * red - 19070 * green + 28784 * blue) >> 16;
      int v = (ROUNDED_128 + 28784 * red - 24103 * green - 4681 * blue) >> 16;
      return (argb & OPACITY) | y << 16 | u << 8 | v;
    }
  };

  private static final int OPACITY = 0xff000000;
  private static final int ROUNDED_16 = (16 << 16) + (1 << 15);
  private static final int ROUNDED_128 = (128 << 16) + (1 << 15);

  private final boolean coarse;

  ColorSpace(boolean coarse) {
    this.coarse = coarse;
  }

  /**
   * Whether a picture has its second and third channel only for pixels in even rows and columns,
   * each for a square of four.
   */
  final boolean coarse() {
    return coarse;
  }

  /** A colour as a packed pixel of this space. */
  abstract int of(int argb);

  /** Where no light is. */
  final int black() {
    return of(OPACITY);
  }
}
