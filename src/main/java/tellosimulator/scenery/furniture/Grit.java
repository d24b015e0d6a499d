package tellosimulator.scenery.furniture;

import tellosimulator.scenery.Rgb;
import tellosimulator.scenery.paint.Field;
import tellosimulator.scenery.paint.Field.Grain;
import tellosimulator.scenery.paint.Shades;

/**
 * What paint in any colour has in common: it is uneven, and has a second colour to go with it.
 *
 * @param pixels edge of the picture of a pattern, a power of two, at most {@link #FINEST}
 */
record Grit(int pixels) {

  /** Decided: as sharp as a wall from half a metre. */
  private static final int FINEST = 512;

  /** Most pictures in the finest size. Decided: they take 60 MB in a window. */
  private static final int MOST_FINEST = 16;

  /** Most pictures in half of the finest size. Decided: they take as much. */
  private static final int MOST_HALF = 64;

  private static final long SEED = 53;

  /** From here on a colour is light, 0 to 1. Decided: by eye. */
  private static final double LIGHT = 0.62;

  private static final class Rough {
    static final Field FIELD =
        new Field(FINEST)
            .rough(new Grain(8, 8), 0.3, SEED)
            .rough(new Grain(32, 32), 0.3, SEED + 1)
            .rough(new Grain(128, 128), 0.4, SEED + 2);
  }

  /** That of so many different pictures: the more there are, the smaller each is. */
  static Grit of(long pictures) {
    if (pictures <= MOST_FINEST) {
      return new Grit(FINEST);
    }
    return new Grit(pictures <= MOST_HALF ? FINEST / 2 : FINEST / 8);
  }

  /** Edge of a pixel [m]. */
  double pixel() {
    return Coat.TILE / pixels;
  }

  /** How far paint is off its mean at a pixel, -1 to 1. */
  double at(int x, int y) {
    int step = FINEST / pixels;
    return Rough.FIELD.at(x * step, y * step);
  }

  /** A colour that stands out against another one: white, or for a light one dark. */
  static Rgb against(Rgb color) {
    return brightness(color) < LIGHT ? Rgb.of(0xf6f4ee) : color.shaded(0.35);
  }

  /**
   * Shades around a colour: 0.5 is the colour.
   *
   * @param spread how far they go, 0 to 1
   */
  static Shades around(Rgb color, double spread) {
    return new Shades(color.shaded(1 - spread), color.towards(Rgb.WHITE, spread));
  }

  private static double brightness(Rgb color) {
    return (0.299 * color.red() + 0.587 * color.green() + 0.114 * color.blue()) / 255;
  }
}
