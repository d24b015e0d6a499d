package tellosimulator.scenery.mesh;

import java.lang.ref.SoftReference;
import java.util.function.Supplier;

/**
 * An image on a mesh. Immutable; for any thread. Textures are compared by identity, so a renderer
 * converts each once.
 */
public final class Texture {

  private final int width;
  private final int height;
  private final Supplier<int[]> source;

  /** What the source gave, until memory is scarce: a camera keeps what it makes of it. */
  private volatile SoftReference<int[]> computed = new SoftReference<>(null);

  /**
   * @param width texels
   * @param height texels
   * @param argb row by row from the top, alpha, red, green and blue with 8 bits each, the colours
   *     not multiplied with alpha
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
   * A texture whose texels are computed when they are first used, as most of a room is not in the
   * first frame, and again if memory was scarce in between.
   *
   * @param texels computes what the constructor takes, each time the same; nobody else keeps the
   *     array
   */
  public static Texture lazy(int width, int height, Supplier<int[]> texels) {
    return new Texture(width, height, texels);
  }

  /**
   * The same image, through which one sees more.
   *
   * @param factor of each texel's opacity, 0 to 1
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

  /** A texel. */
  public int argb(int x, int y) {
    return texels()[y * width + x];
  }

  /** A copy of all texels, row by row. */
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
