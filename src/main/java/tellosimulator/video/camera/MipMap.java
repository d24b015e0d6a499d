package tellosimulator.video.camera;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.scenery.mesh.Texture;

/**
 * A mip-mapped texture in a colour space. Its sides are powers of two, and each level is half as
 * large as the previous one, so that there is a level at which about one texel falls on one pixel.
 * Immutable.
 */
final class MipMap {

  /**
   * Maximum length of a side [texels]. Decided: on a wall of 5 m, one texel covers one pixel when
   * seen from 4.5 m.
   */
  private static final int MAX_SIZE = 1024;

  /** The size of one texel in fixed-point texture coordinates. */
  static final int ONE = 1 << 16;

  private final Level[] levels;
  private final double[] uScale;
  private final double[] vScale;

  /**
   * A mip level. If the colour space subsamples chroma ({@link ColorSpace#subsampled()}), the
   * second and third channel and their alpha are taken from the next level, which is half as wide
   * and high, so that about one of their texels falls on one chroma sample.
   */
  record Level(
      BilinearTexels first,
      BilinearTexels second,
      BilinearTexels third,
      BilinearTexels alpha,
      BilinearTexels chromaAlpha) {

    private static Level opaque(Texels luma, Texels chroma) {
      return new Level(
          luma.channel(Texels.FIRST),
          chroma.channel(Texels.SECOND),
          chroma.channel(Texels.THIRD),
          BilinearTexels.OPAQUE,
          BilinearTexels.OPAQUE);
    }

    private static Level translucent(Texels luma, Texels chroma) {
      return new Level(
          luma.channel(Texels.FIRST),
          chroma.channel(Texels.SECOND),
          chroma.channel(Texels.THIRD),
          luma.channel(Texels.ALPHA),
          chroma.channel(Texels.ALPHA));
    }

    int width() {
      return first.width();
    }

    int height() {
      return first.height();
    }
  }

  /**
   * Builds all levels.
   *
   * @param alpha whether the alpha channel of the texture is used; if so, colours are premultiplied
   *     with it
   */
  MipMap(Texture texture, ColorSpace space, boolean alpha) {
    List<Texels> chain = chain(Texels.of(texture, space, alpha).powerOfTwo(MAX_SIZE));
    levels = new Level[chain.size()];
    for (int i = 0; i < levels.length; i++) {
      Texels luma = chain.get(i);
      Texels chroma = space.subsampled() ? chain.get(Math.min(i + 1, levels.length - 1)) : luma;
      levels[i] = alpha ? Level.translucent(luma, chroma) : Level.opaque(luma, chroma);
    }
    uScale = chain.stream().mapToDouble(level -> (double) ONE * level.width() / width()).toArray();
    vScale =
        chain.stream().mapToDouble(level -> (double) ONE * level.height() / height()).toArray();
  }

  private static List<Texels> chain(Texels base) {
    List<Texels> chain = new ArrayList<>(List.of(base));
    Texels next = base;
    while (next.width() > 1 || next.height() > 1) {
      next = next.halved();
      chain.add(next);
    }
    return chain;
  }

  /** The width of level 0 [texels]. */
  int width() {
    return levels[0].width();
  }

  /** The height of level 0 [texels]. */
  int height() {
    return levels[0].height();
  }

  /** The number of levels. */
  int levels() {
    return levels.length;
  }

  /**
   * Returns a mip level.
   *
   * @param number 0 for the largest level
   */
  Level level(int number) {
    return levels[number];
  }

  /**
   * Returns the factor that converts u from texels of level 0 to fixed-point texels of another
   * level.
   */
  double uScale(int number) {
    return uScale[number];
  }

  /**
   * Returns the factor that converts v from texels of level 0 to fixed-point texels of another
   * level.
   */
  double vScale(int number) {
    return vScale[number];
  }
}
