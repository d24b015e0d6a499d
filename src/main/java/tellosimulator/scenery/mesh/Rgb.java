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

  /** The colour that one writes as #rrggbb. */
  public static Rgb of(int hex) {
    return new Rgb(hex >> 16 & 0xff, hex >> 8 & 0xff, hex & 0xff);
  }

  /** A texel of this colour. */
  public int argb() {
    return 0xff << 24 | red << 16 | green << 8 | blue;
  }

  /**
   * The same, translucent.
   *
   * @param opacity 0 to 1
   */
  public int argb(double opacity) {
    return (int) Math.round(255 * opacity) << 24 | red << 16 | green << 8 | blue;
  }

  /**
   * A colour on the way to another.
   *
   * @param part of the way, 0 to 1
   */
  public Rgb towards(Rgb other, double part) {
    return new Rgb(
        between(red, other.red, part),
        between(green, other.green, part),
        between(blue, other.blue, part));
  }

  /**
   * The same in another light.
   *
   * @param factor of its brightness, 0 to 1
   */
  public Rgb shaded(double factor) {
    return BLACK.towards(this, factor);
  }

  /**
   * The same, equally bright, but nearer to grey.
   *
   * @param factor of its saturation, 0 to 1
   */
  public Rgb paler(double factor) {
    int most = Math.max(red, Math.max(green, blue));
    return new Rgb(most, most, most).towards(this, factor);
  }

  /** Luma (ITU-R BT.601), 0 to 1. */
  public double luma() {
    return (0.299 * red + 0.587 * green + 0.114 * blue) / 255;
  }

  private static int between(int from, int to, double part) {
    return (int) Math.round(from + (to - from) * part);
  }
}
