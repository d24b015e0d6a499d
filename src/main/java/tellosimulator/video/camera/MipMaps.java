package tellosimulator.video.camera;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.scenery.Texture;

/**
 * A texture ready for drawing: in a colour space, sides powers of two, with ever smaller versions
 * of it, so that about one of its pixels falls on one of the picture. Immutable; for any thread.
 */
final class MipMaps {

  /** Largest side in pixels. Decided: finer than a wall of 5 m looks from a metre away. */
  private static final int LARGEST = 1024;

  /** A pixel of a texture, where places in it are whole numbers. */
  static final int ONE = 1 << 16;

  private final Level[] levels;
  private final double[] uScale;
  private final double[] vScale;

  /**
   * @param masked whether the texture's opacity counts; colours are then multiplied with it
   */
  MipMaps(Texture texture, ColorSpace space, boolean masked) {
    List<Texels> all = versions(Texels.of(texture, space, masked).squared(LARGEST));
    levels = new Level[all.size()];
    for (int i = 0; i < levels.length; i++) {
      Texels fine = all.get(i);
      Texels coarse = space.coarse() ? all.get(Math.min(i + 1, levels.length - 1)) : fine;
      levels[i] = masked ? Level.masked(fine, coarse) : Level.opaque(fine, coarse);
    }
    uScale = all.stream().mapToDouble(level -> (double) ONE * level.width() / width()).toArray();
    vScale = all.stream().mapToDouble(level -> (double) ONE * level.height() / height()).toArray();
  }

  /** A texture and ever smaller ones. */
  private static List<Texels> versions(Texels largest) {
    List<Texels> all = new ArrayList<>(List.of(largest));
    Texels next = largest;
    while (next.width() > 1 || next.height() > 1) {
      next = next.halved();
      all.add(next);
    }
    return all;
  }

  /** The width of the largest version in pixels. */
  int width() {
    return levels[0].width();
  }

  /** The height of the largest version in pixels. */
  int height() {
    return levels[0].height();
  }

  /** The number of versions. */
  int levels() {
    return levels.length;
  }

  /**
   * A version.
   *
   * @param number 0 is the largest; each is half as large as the one before
   */
  Level level(int number) {
    return levels[number];
  }

  /** From pixels of the largest version to those of another, across, times {@link #ONE}. */
  double uScale(int number) {
    return uScale[number];
  }

  /** From pixels of the largest version to those of another, down, times {@link #ONE}. */
  double vScale(int number) {
    return vScale[number];
  }
}
