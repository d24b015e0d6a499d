package tellosimulator.video.camera;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.scenery.Texture;

/**
 * A texture ready for drawing: in a colour space, sides powers of two, with ever smaller versions
 * of it, so that no more than about one of its pixels falls on one of the picture. Each version has
 * its first column and row once more behind its last, so that neighbours need no thought.
 * Immutable; for any thread.
 */
final class MipMaps {

  /** Largest side in pixels. Decided: finer than a wall of 5 m looks from a metre away. */
  private static final int LARGEST = 1024;

  /** A pixel of a texture, where places in it are whole numbers. */
  static final int ONE = 1 << 16;

  private final Level[] levels;
  private final double[] uScale;
  private final double[] vScale;

  /** A version of the texture. */
  static final class Level {

    private final int width;
    private final int height;
    private final long[] texels;

    Level(int width, int height, long[] texels) {
      this.width = width;
      this.height = height;
      this.texels = texels;
    }

    /** A power of two. */
    int width() {
      return width;
    }

    /** A power of two. */
    int height() {
      return height;
    }

    /** {@link Lanes}, row by row, with a column and a row more; not a copy. */
    long[] texels() {
      return texels;
    }
  }

  /**
   * @param masked whether the texture's opacity counts; colours are then multiplied with it
   */
  MipMaps(Texture texture, ColorSpace space, boolean masked) {
    Texels whole = Texels.of(texture, space, masked).resized(LARGEST);
    List<Level> all = new ArrayList<>(List.of(whole.level()));
    while (whole.width() > 1 || whole.height() > 1) {
      whole = whole.halved();
      all.add(whole.level());
    }
    levels = all.toArray(Level[]::new);
    uScale = all.stream().mapToDouble(level -> (double) ONE * level.width() / width()).toArray();
    vScale = all.stream().mapToDouble(level -> (double) ONE * level.height() / height()).toArray();
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

  /** The colour at a place of the largest version, {@link Lanes}. */
  long color(float u, float v) {
    Level largest = levels[0];
    int x = (int) Math.floor(u * width()) & width() - 1;
    int y = (int) Math.floor(v * height()) & height() - 1;
    return largest.texels()[y * (width() + 1) + x];
  }
}
