package tellosimulator.scenery;

import java.util.function.Supplier;

/**
 * A picture to be put on a mesh. Immutable; for any thread. Two of them are equal only if they are
 * the same, so whoever converts textures can keep what was converted.
 */
public final class Texture {

  private final int width;
  private final int height;
  private Supplier<int[]> painter;
  private volatile int[] argb;

  /**
   * @param width pixels
   * @param height pixels
   * @param argb row by row from the top, alpha, red, green and blue with 8 bits each, the colours
   *     not multiplied with alpha
   */
  public Texture(int width, int height, int[] argb) {
    this(width, height, (Supplier<int[]>) null);
    check(argb);
    this.argb = argb.clone();
  }

  private Texture(int width, int height, Supplier<int[]> painter) {
    this.width = width;
    this.height = height;
    this.painter = painter;
  }

  /**
   * A texture that is painted when its pixels are first asked for, as most of a room is not in the
   * first picture.
   *
   * @param painter makes the pixels as the constructor takes them, which nobody else keeps
   */
  public static Texture painted(int width, int height, Supplier<int[]> painter) {
    return new Texture(width, height, painter);
  }

  public int width() {
    return width;
  }

  public int height() {
    return height;
  }

  /** A pixel. */
  public int argb(int x, int y) {
    return pixels()[y * width + x];
  }

  /** A copy of all pixels, row by row. */
  public int[] argbArray() {
    return pixels().clone();
  }

  private int[] pixels() {
    int[] known = argb;
    return known == null ? paint() : known;
  }

  private synchronized int[] paint() {
    if (argb == null) {
      int[] made = painter.get();
      check(made);
      argb = made;
      painter = null; // with all it needed for painting
    }
    return argb;
  }

  private void check(int[] pixels) {
    if (pixels.length != width * height) {
      throw new IllegalArgumentException(
          "argb has " + pixels.length + " pixels, but must have " + width + " times " + height);
    }
  }
}
