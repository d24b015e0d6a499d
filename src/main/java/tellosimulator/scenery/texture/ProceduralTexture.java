package tellosimulator.scenery.texture;

import java.util.function.DoubleToIntFunction;
import java.util.function.Supplier;
import tellosimulator.scenery.mesh.Texture;

/** Creates square textures that are computed texel by texel. */
public final class ProceduralTexture {

  /** The colour of each texel: alpha, red, green and blue with 8 bits each. */
  @FunctionalInterface
  public interface Texels {
    int argb(int x, int y);
  }

  private ProceduralTexture() {}

  /**
   * Returns a texture that is computed on first use.
   *
   * @param size side length of the texture [texels]
   * @param texels creates the function that returns the colour of a texel
   */
  public static Texture of(int size, Supplier<Texels> texels) {
    return Texture.lazy(size, size, () -> argb(size, texels.get()));
  }

  /**
   * Returns a texture with radial symmetry. The texture is computed on first use.
   *
   * @param size side length of the texture [texels]
   * @param argb returns the colour for a closeness to the centre: 1 at the centre, 0 at the edges
   *     and in the corners
   */
  public static Texture radial(int size, DoubleToIntFunction argb) {
    double radius = size / 2.0;
    return of(
        size,
        () ->
            (x, y) -> {
              double right = (x + 0.5) / radius - 1;
              double down = (y + 0.5) / radius - 1;
              double near = Math.max(0, 1 - Math.sqrt(right * right + down * down));
              return argb.applyAsInt(near);
            });
  }

  private static int[] argb(int size, Texels texels) {
    int[] argb = new int[size * size];
    for (int y = 0; y < size; y++) {
      for (int x = 0; x < size; x++) {
        argb[y * size + x] = texels.argb(x, y);
      }
    }
    return argb;
  }

  /**
   * Interpolates linearly between two opaque colours.
   *
   * @param weight weight of the second colour; values outside 0 to 1 are clamped
   */
  public static int mix(int from, int to, double weight) {
    int share = (int) (256 * Math.max(0, Math.min(1, weight)));
    int rest = 256 - share;
    int redAndBlue = (((from & 0xff00ff) * rest + (to & 0xff00ff) * share) >>> 8) & 0xff00ff;
    int green = (((from & 0xff00) * rest + (to & 0xff00) * share) >>> 8) & 0xff00;
    return (from & 0xff000000) | redAndBlue | green;
  }
}
