package tellosimulator.scenery;

/**
 * A picture to be put on a mesh. Immutable; for any thread. Two of them are equal only if they are
 * the same, so whoever converts textures can keep what was converted.
 */
public final class Texture {

  private final int width;
  private final int height;
  private final int[] argb;

  /**
   * @param width pixels
   * @param height pixels
   * @param argb row by row from the top, alpha, red, green and blue with 8 bits each, the colours
   *     not multiplied with alpha
   */
  public Texture(int width, int height, int[] argb) {
    if (argb.length != width * height) {
      throw new IllegalArgumentException(
          "argb has " + argb.length + " pixels, but must have " + width + " times " + height);
    }
    this.width = width;
    this.height = height;
    this.argb = argb.clone();
  }

  public int width() {
    return width;
  }

  public int height() {
    return height;
  }

  /** A pixel. */
  public int argb(int x, int y) {
    return argb[y * width + x];
  }

  /** A copy of all pixels, row by row. */
  public int[] argbArray() {
    return argb.clone();
  }
}
