package tellosimulator.scenery.mesh;

import java.lang.ref.SoftReference;
import java.util.function.Supplier;

/**
 * An image on a mesh. Immutable. Textures are compared by identity, so a renderer converts each
 * texture only once.
 */
public final class Texture {

  private final int width;
  private final int height;
  private final Supplier<int[]> source;

  /**
   * The computed texels. They may be dropped when memory is scarce, because each camera keeps its
   * own converted copy.
   */
  private volatile SoftReference<int[]> computed = new SoftReference<>(null);

  /**
   * Creates a texture from a copy of its texels.
   *
   * @param width width in texels
   * @param height height in texels
   * @param argb texels row by row from the top: alpha, red, green and blue with 8 bits each; the
   *     colours are not premultiplied
   */
  public Texture(int width, int height, int[] argb) {
    this(width, height, constant(argb.clone()));
    check(argb);
  }

  private Texture(int width, int height, Supplier<int[]> source) {
    this.width = width;
    this.height = height;
    this.source = source;
  }

  private static Supplier<int[]> constant(int[] argb) {
    return () -> argb;
  }

  /**
   * Returns a texture whose texels are computed on first use, because most of a room is not visible
   * in the first frame. If memory has become scarce in the meantime, they are computed again.
   *
   * @param texels computes the array that the constructor takes, each time with the same contents;
   *     must not keep a reference to the array
   */
  public static Texture lazy(int width, int height, Supplier<int[]> texels) {
    return new Texture(width, height, texels);
  }

  /**
   * Returns a more transparent copy of this texture.
   *
   * @param factor factor for the opacity of each texel, 0 to 1
   */
  public Texture faded(double factor) {
    int[] argb = argbArray();
    for (int i = 0; i < argb.length; i++) {
      argb[i] = Rgb.of(argb[i]).argb(factor * (argb[i] >>> 24) / 255.0);
    }
    return new Texture(width, height, argb);
  }

  public int width() {
    return width;
  }

  public int height() {
    return height;
  }

  /** Returns a texel. */
  public int argb(int x, int y) {
    return texels()[y * width + x];
  }

  /** Returns a copy of all texels, row by row. */
  public int[] argbArray() {
    return texels().clone();
  }

  private int[] texels() {
    int[] known = computed.get();
    return known == null ? compute() : known;
  }

  private synchronized int[] compute() {
    int[] argb = computed.get();
    if (argb == null) {
      argb = source.get();
      check(argb);
      computed = new SoftReference<>(argb);
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
