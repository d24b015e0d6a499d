package tellosimulator.scenery.overlay;

import java.util.Arrays;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;

/**
 * The translucent textures of goals. They are drawn unlit, so light and shade are baked into them.
 * Decided: all proportions were chosen by eye.
 */
final class GoalTextures {

  /** Width of the texture of a ball [texels]. */
  private static final int AROUND = 256;

  /** Height of the texture of a ball [texels]. */
  static final int DOWN = 64;

  /** Number of lines from pole to pole on a ball. */
  private static final int MERIDIANS = 8;

  /** Side length of the texture of a circle [texels]. */
  private static final int CIRCLE = 128;

  /** Opacity of the white area in a circle. */
  private static final double WHITE = 0.5;

  /** Length of the gradient of a beacon, and of a dash with its gap [texels]. */
  static final int LENGTH = 16;

  private GoalTextures() {}

  /**
   * Returns the texture of a translucent ball that is brighter at its top and has an equator and
   * meridians.
   *
   * @param opacity opacity of the lines, 0 to 1; the areas between them have a third of it
   */
  static Texture ball(Rgb color, double opacity) {
    int[] argb = new int[AROUND * DOWN];
    Arrays.setAll(
        argb,
        i -> {
          int row = i / AROUND;
          int column = i % AROUND;
          boolean equator = row == DOWN / 2 - 1 || row == DOWN / 2;
          int next = Math.floorMod(column + 1, AROUND / MERIDIANS);
          boolean line = equator || next < 2;
          double up = 1 - 2 * (row + 0.5) / DOWN;
          Rgb lit = up > 0 ? color.towards(Rgb.WHITE, 0.4 * up) : color.shaded(1 + 0.35 * up);
          return lit.argb(line ? opacity : 0.33 * opacity);
        });
    return new Texture(AROUND, DOWN, argb);
  }

  /**
   * Returns the texture of a disc with a strong rim and an inner ring on translucent white. The
   * disc is visible both on dark floors and on light floors.
   *
   * @param opacity opacity of the rim, 0 to 1
   */
  static Texture circle(Rgb color, double opacity) {
    int[] argb = new int[CIRCLE * CIRCLE];
    Arrays.setAll(
        argb,
        i -> {
          int row = i / CIRCLE;
          double x = (i - row * CIRCLE + 0.5) * 2 / CIRCLE - 1;
          double y = (row + 0.5) * 2 / CIRCLE - 1;
          double radius = Math.sqrt(x * x + y * y);
          double rim = edge(0.96 - radius) * edge(radius - 0.8);
          double ring = edge(0.54 - radius) * edge(radius - 0.42);
          double middle = edge(0.13 - radius);
          double drawn = opacity * Math.max(rim, Math.max(ring, middle));
          double covered = drawn + (1 - drawn) * WHITE * edge(1 - radius);
          return Rgb.WHITE.towards(color, covered == 0 ? 1 : drawn / covered).argb(covered);
        });
    return new Texture(CIRCLE, CIRCLE, argb);
  }

  /**
   * Returns the coverage at a given distance from an edge of a circle. The coverage rises from 0 to
   * 1 over two texels.
   *
   * @param within distance as a fraction of half the side length of the texture, positive inside
   */
  private static double edge(double within) {
    return Math.max(0, Math.min(1, 0.5 + within * CIRCLE / 4));
  }

  /** Returns the texture of a beacon: light that rises from the rim of a circle and fades. */
  static Texture beacon(Rgb color) {
    int[] argb = new int[LENGTH];
    Arrays.setAll(argb, row -> color.argb(0.6 * row / (LENGTH - 1)));
    return new Texture(1, LENGTH, argb);
  }

  /** Returns the texture of a dash and the gap after it. */
  static Texture dash(Rgb color) {
    int[] argb = new int[LENGTH];
    Arrays.setAll(argb, row -> color.argb(row < LENGTH * 5 / 8 ? 0.9 : 0));
    return new Texture(1, LENGTH, argb);
  }

  /**
   * Returns the texture of a round surface. The middle of the texture is on the surface's upper
   * side.
   */
  static Texture round(Rgb color, double opacity) {
    int[] argb = new int[LENGTH];
    Arrays.setAll(
        argb,
        column -> {
          double up = -StrictMath.cos(2 * Math.PI * (column + 0.5) / LENGTH);
          Rgb lit = up > 0 ? color.towards(Rgb.WHITE, 0.45 * up) : color.shaded(1 + 0.35 * up);
          return lit.argb(opacity);
        });
    return new Texture(LENGTH, 1, argb);
  }

  /** Returns a texture of one colour. */
  static Texture plain(Rgb color, double opacity) {
    return new Texture(1, 1, new int[] {color.argb(opacity)});
  }
}
