package tellosimulator.scenery.mesh;

import java.util.function.Supplier;

/**
 * An image on a mesh. Immutable; for any thread. Textures are compared by identity, so a renderer
 * converts each once.
 */
public final class Texture {

  private final int width;
  private final int height;
  private Supplier<int[]> lazyArgb;
  private volatile int[] argb;

  /**
   * @param width texels
   * @param height texels
   * @param argb row by row from the top, alpha, red, green and blue with 8 bits each, the colours
   *     not multiplied with alpha
   */
  public Texture(int width, int height, int[] argb) {
    this(width, height, (Supplier<int[]>) null);
    check(argb);
    this.argb = argb.clone();
  }

  private Texture(int width, int height, Supplier<int[]> lazyArgb) {
    this.width = width;
    this.height = height;
    this.lazyArgb = lazyArgb;
  }

  /**
   * A texture whose texels are computed when they are first used, as most of a room is not in the
   * first frame.
   *
   * @param texels computes what the constructor takes; nobody else keeps the array
   */
  public static Texture lazy(int width, int height, Supplier<int[]> texels) {
    return new Texture(width, height, texels);
  }

  public int width() {
    return width;
  }

  public int height() {
    return height;
  }

  /** A texel. */
  public int argb(int x, int y) {
    return texels()[y * width + x];
  }

  /** A copy of all texels, row by row. */
  public int[] argbArray() {
    return texels().clone();
  }

  private int[] texels() {
    int[] known = argb;
    return known == null ? compute() : known;
  }

  private synchronized int[] compute() {
    if (argb == null) {
      int[] made = lazyArgb.get();
      check(made);
      argb = made;
      lazyArgb = null; // with all that it refers to
    }
    return argb;
  }

  private void check(int[] texels) {
    if (texels.length != width * height) {
      throw new IllegalArgumentException(
          "argb has " + texels.length + " texels, but must have " + width + " times " + height);
    }
  }
}
