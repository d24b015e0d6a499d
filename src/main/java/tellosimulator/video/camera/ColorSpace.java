package tellosimulator.video.camera;

/**
 * The colour space of the three channels of a frame buffer. A packed pixel has 8 bits each for
 * alpha (uppermost) and for the first, second and third channel. Rendering works in the same way in
 * both colour spaces, because interpolation and blending are linear.
 */
public enum ColorSpace {
  /** Red, green and blue at full range; packed as ARGB. */
  RGB(false) {
    @Override
    int pack(int argb) {
      return argb;
    }
  },

  /**
   * Y, Cb and Cr of ITU-R BT.601 at limited range, in 4:2:0. Decoders assume this if a stream does
   * not specify its colour space.
   */
  YUV(true) {
    @Override
    int pack(int argb) {
      int red = (argb >> 16) & 255;
      int green = (argb >> 8) & 255;
      int blue = argb & 255;
      int y = (ROUNDED_16 + 16829 * red + 33039 * green + 6416 * blue) >> 16;
      int cb = (ROUNDED_128 - 9714 * red - 19070 * green + 28784 * blue) >> 16;
      int cr = (ROUNDED_128 + 28784 * red - 24103 * green - 4681 * blue) >> 16;
      return (argb & ALPHA) | y << 16 | cb << 8 | cr;
    }
  };

  private static final int ALPHA = 0xff000000;
  private static final int ROUNDED_16 = (16 << 16) + (1 << 15);
  private static final int ROUNDED_128 = (128 << 16) + (1 << 15);

  private final boolean subsampled;

  ColorSpace(boolean subsampled) {
    this.subsampled = subsampled;
  }

  /**
   * Whether the second and third channel are subsampled as in 4:2:0. In this case there is one
   * sample for 2x2 pixels, taken from the pixel in the even row and column.
   */
  final boolean subsampled() {
    return subsampled;
  }

  /** Converts an ARGB colour to a packed pixel of this space. */
  abstract int pack(int argb);

  /** Opaque black. */
  final int black() {
    return pack(ALPHA);
  }
}
