package tellosimulator.scenery.furniture;

import java.util.function.Supplier;
import tellosimulator.scenery.Rgb;
import tellosimulator.scenery.Texture;
import tellosimulator.scenery.paint.Tile;
import tellosimulator.world.Cover.Pattern;

/**
 * What is on surfaces: a colour, a pattern in it whose picture repeats, or a picture. Immutable;
 * for any thread.
 */
final class Coat {

  /** Edge of the square that repeats [m]. Decided: whole bricks and squares. */
  static final double TILE = 1;

  /**
   * Where a length is in a picture.
   *
   * @param start where 0 m is, in parts of the picture
   * @param step how much of the picture a metre is
   */
  private record Scale(double start, double step) {

    /** Always the same place. */
    static final Scale NONE = new Scale(0.5, 0);

    /** From the middle of the first pixel to that of the last, or the picture's edges would mix. */
    static Scale over(double length, int pixels) {
      return new Scale(0.5 / pixels, (1 - 1.0 / pixels) / length);
    }

    double at(double metres) {
      return start + step * metres;
    }
  }

  private final Texture texture;
  private final double period;
  private final Scale across;
  private final Scale down;

  private Coat(Texture texture, double period, Scale across, Scale down) {
    this.texture = texture;
    this.period = period;
    this.across = across;
    this.down = down;
  }

  /**
   * A new coat of paint with a pattern.
   *
   * @param size of the pattern's picture
   */
  static Coat of(Pattern pattern, Rgb color, Grit size) {
    return switch (pattern) {
      case PLAIN -> plain(color);
      case CHECKS -> patterned(size, Checks.PERIOD, () -> new Checks(color, size)::argb);
      case STRIPES -> patterned(size, Stripes.PERIOD, () -> new Stripes(color, size)::argb);
      case BRICKS -> patterned(size, Bricks.PERIOD, () -> new Bricks(color, size)::argb);
    };
  }

  /** A new coat of paint without a pattern. */
  static Coat plain(Rgb color) {
    Texture texture = new Texture(1, 1, new int[] {color.argb()});
    return new Coat(texture, TILE, Scale.NONE, Scale.NONE);
  }

  private static Coat patterned(Grit size, double period, Supplier<Tile.Look> look) {
    Scale whole = new Scale(0, 1 / TILE);
    return new Coat(Tile.painted(size.pixels(), look), period, whole, whole);
  }

  /**
   * A picture, once.
   *
   * @param width of what it covers [m]
   * @param height of what it covers [m]
   */
  static Coat ofPicture(Texture picture, double width, double height) {
    return new Coat(
        picture, width, Scale.over(width, picture.width()), Scale.over(height, picture.height()));
  }

  Texture texture() {
    return texture;
  }

  /**
   * A length near to one that goes once around a thing, after which the pattern begins anew, so
   * that one sees no seam [m].
   */
  double closed(double around) {
    return Math.max(1, Math.rint(around / period)) * period;
  }

  /** Where that many metres to the right are in the picture. */
  double u(double right) {
    return across.at(right);
  }

  /** Where that many metres up are in the picture. */
  double v(double up) {
    return 1 - down.at(up);
  }
}
