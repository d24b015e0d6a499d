package tellosimulator.scenery.mesh;

/**
 * An opaque colour.
 *
 * @param red 0 to 255
 * @param green 0 to 255
 * @param blue 0 to 255
 */
public record Rgb(int red, int green, int blue) {

  public static final Rgb WHITE = of(0xffffff);

  public static final Rgb BLACK = of(0x000000);

  /** Returns the colour that a number of the form {@code 0xrrggbb} describes. */
  public static Rgb of(int hex) {
    return new Rgb(hex >> 16 & 0xff, hex >> 8 & 0xff, hex & 0xff);
  }

  /** Returns an opaque texel of this colour. */
  public int argb() {
    return 0xff << 24 | red << 16 | green << 8 | blue;
  }

  /**
   * Returns a translucent texel of this colour.
   *
   * @param opacity 0 to 1
   */
  public int argb(double opacity) {
    return (int) Math.round(255 * opacity) << 24 | red << 16 | green << 8 | blue;
  }

  /**
   * Interpolates linearly between this colour and another.
   *
   * @param part 0 for this colour, 1 for the other
   */
  public Rgb towards(Rgb other, double part) {
    return new Rgb(
        between(red, other.red, part),
        between(green, other.green, part),
        between(blue, other.blue, part));
  }

  /**
   * Returns a darker shade of this colour.
   *
   * @param factor factor for the brightness, 0 to 1
   */
  public Rgb shaded(double factor) {
    return BLACK.towards(this, factor);
  }

  /**
   * Returns a less saturated colour of the same brightness (HSV value).
   *
   * @param factor factor for the saturation, 0 to 1
   */
  public Rgb paler(double factor) {
    int most = Math.max(red, Math.max(green, blue));
    return new Rgb(most, most, most).towards(this, factor);
  }

  /** Returns the luma (ITU-R BT.601), 0 to 1. */
  public double luma() {
    return (0.299 * red + 0.587 * green + 0.114 * blue) / 255;
  }

  private static int between(int from, int to, double part) {
    return (int) Math.round(from + (to - from) * part);
  }
}
