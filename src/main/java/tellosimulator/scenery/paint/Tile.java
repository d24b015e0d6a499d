package tellosimulator.scenery.paint;

import java.util.function.Supplier;
import tellosimulator.scenery.Texture;

/** Makes the picture of a surface that repeats, pixel by pixel. */
public final class Tile {

  /** What a pixel looks like: alpha, red, green and blue with 8 bits each. */
  @FunctionalInterface
  public interface Look {
    int argb(int x, int y);
  }

  private Tile() {}

  /**
   * A square picture, painted when it is first looked at.
   *
   * @param size its edge [pixels]
   * @param look makes what the pixels look like; is asked once
   */
  public static Texture painted(int size, Supplier<Look> look) {
    return Texture.painted(size, size, () -> pixels(size, look.get()));
  }

  static int[] pixels(int size, Look look) {
    int[] pixels = new int[size * size];
    for (int y = 0; y < size; y++) {
      for (int x = 0; x < size; x++) {
        pixels[y * size + x] = look.argb(x, y);
      }
    }
    return pixels;
  }

  /**
   * A colour on the way from one to another.
   *
   * @param part of the way; below 0 and beyond 1 it stays at the ends
   */
  public static int mixed(int from, int to, double part) {
    int weight = (int) (256 * Math.max(0, Math.min(1, part)));
    int rest = 256 - weight;
    int redAndBlue = (((from & 0xff00ff) * rest + (to & 0xff00ff) * weight) >>> 8) & 0xff00ff;
    int green = (((from & 0xff00) * rest + (to & 0xff00) * weight) >>> 8) & 0xff00;
    return (from & 0xff000000) | redAndBlue | green;
  }
}
