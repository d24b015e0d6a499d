package tellosimulator.scenery.room;

import java.util.Arrays;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;

/**
 * The textures of plain rooms ({@code Walls.PLAIN}): a grid on the floor, and a horizontal line on
 * the walls at each metre.
 */
final class PlainTextures {

  private static final Rgb FLOOR = Rgb.of(0xd9d4ca);
  private static final Rgb FLOOR_LINE = Rgb.of(0xaaa295);
  private static final Rgb WALL_LOW = Rgb.of(0xcfc9be);
  private static final Rgb WALL_HIGH = Rgb.of(0xece8e1);
  private static final Rgb WALL_LINE = Rgb.of(0xc2bbaf);
  private static final Rgb SKIRTING = Rgb.of(0x8f877b);

  /** Height of the skirting board [m]. Assumed: as in most rooms. */
  static final double SKIRTING_HEIGHT = 0.06;

  private static final int TILE = 256;
  private static final int STRIP_WIDTH = 4;
  private static final int STRIP_HEIGHT = 1024;

  private PlainTextures() {}

  /**
   * Returns a tile of the floor, with lines through its middle.
   *
   * @param grid side length of the tile [m]
   */
  static Texture floor(double grid) {
    int[] pixels = new int[TILE * TILE];
    double halfLine = Math.max(1.5, (0.0035 / grid + 0.0075) * TILE);
    for (int i = 0; i < pixels.length; i++) {
      double nearest = Math.min(fromMiddle(i % TILE), fromMiddle(i / TILE));
      double line = Math.max(0, Math.min(1, halfLine - nearest + 0.5));
      pixels[i] = FLOOR.towards(FLOOR_LINE, line).argb();
    }
    return new Texture(TILE, TILE, pixels);
  }

  private static double fromMiddle(int pixel) {
    return Math.abs(pixel + 0.5 - TILE / 2.0);
  }

  /**
   * Returns a strip of a wall from floor to ceiling.
   *
   * @param height height of the room [m]
   * @param shade brightness factor; 1 leaves the brightness unchanged
   */
  static Texture wall(double height, double shade) {
    int[] pixels = new int[STRIP_WIDTH * STRIP_HEIGHT];
    double pixel = height / STRIP_HEIGHT;
    for (int y = 0; y < STRIP_HEIGHT; y++) {
      double above = (STRIP_HEIGHT - y - 0.5) * pixel;
      Rgb color = wallColor(above, Math.max(pixel, 0.012)).shaded(shade);
      Arrays.fill(pixels, y * STRIP_WIDTH, (y + 1) * STRIP_WIDTH, color.argb());
    }
    return new Texture(STRIP_WIDTH, STRIP_HEIGHT, pixels);
  }

  private static Rgb wallColor(double above, double line) {
    if (above < SKIRTING_HEIGHT) {
      return SKIRTING;
    }
    double fromMeter = Math.abs(above - Math.rint(above));
    return fromMeter < line / 2 ? WALL_LINE : WALL_LOW.towards(WALL_HIGH, Math.min(1, above / 2.5));
  }
}
