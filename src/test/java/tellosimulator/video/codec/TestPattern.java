package tellosimulator.video.codec;

import java.util.Arrays;
import java.util.Random;
import tellosimulator.video.picture.Picture;

/**
 * A demanding test pattern for encoders: a texture with coarse and fine detail that repeats in all
 * directions. The same seed results in the same pattern.
 */
final class TestPattern {

  /** Period of the texture [pixels]; a power of 2. */
  private static final int PERIOD = 1024;

  /** Distance between two points of the coarse detail [pixels]. */
  private static final int COARSE = 16;

  private final int[] texture = new int[PERIOD * PERIOD];
  private final Random random;

  TestPattern(long seed) {
    random = new Random(seed);
    int[] points = random.ints(PERIOD / COARSE * PERIOD / COARSE, 40, 200).toArray();
    for (int y = 0; y < PERIOD; y++) {
      for (int x = 0; x < PERIOD; x++) {
        texture[y * PERIOD + x] = coarse(points, x, y) + random.nextInt(-12, 13);
      }
    }
  }

  private static int coarse(int[] points, int x, int y) {
    int columns = PERIOD / COARSE;
    int column = x / COARSE;
    int row = y / COARSE;
    int beside = (column + 1) % columns;
    int below = (row + 1) % columns;
    int above = mix(points[row * columns + column], points[row * columns + beside], x % COARSE);
    int under = mix(points[below * columns + column], points[below * columns + beside], x % COARSE);
    return mix(above, under, y % COARSE);
  }

  private static int mix(int from, int to, int part) {
    return from + (to - from) * part / COARSE;
  }

  /** Fills a picture with one luma, without colour. */
  static void flat(Picture picture, int brightness) {
    Arrays.fill(picture.y(), (byte) brightness);
    Arrays.fill(picture.u(), (byte) 128);
    Arrays.fill(picture.v(), (byte) 128);
  }

  /** Fills a picture with random samples, unrelated to the previous picture. */
  void noise(Picture picture) {
    random.nextBytes(picture.y());
    random.nextBytes(picture.u());
    random.nextBytes(picture.v());
  }

  /**
   * Fills a picture with a part of the texture.
   *
   * @param left edge of the part in quarters of a pixel
   * @param top edge of the part in quarters of a pixel
   */
  void textured(Picture picture, int left, int top) {
    plane(picture.y(), picture.width(), left, top);
    plane(picture.u(), picture.width() / 2, left / 2 + 4 * 100, top / 2);
    plane(picture.v(), picture.width() / 2, left / 2, top / 2 + 4 * 200);
  }

  private void plane(byte[] plane, int width, int left, int top) {
    for (int i = 0; i < plane.length; i++) {
      plane[i] = (byte) sample(left + 4 * (i % width), top + 4 * (i / width));
    }
  }

  /** Interpolates between the points of the texture. */
  private int sample(int x, int y) {
    int column = (x >> 2) & (PERIOD - 1);
    int row = (y >> 2) & (PERIOD - 1);
    int beside = (column + 1) & (PERIOD - 1);
    int below = (row + 1) & (PERIOD - 1);
    int partX = x & 3;
    int above =
        texture[row * PERIOD + column] * (4 - partX) + texture[row * PERIOD + beside] * partX;
    int under =
        texture[below * PERIOD + column] * (4 - partX) + texture[below * PERIOD + beside] * partX;
    return (above * (4 - (y & 3)) + under * (y & 3) + 8) >> 4;
  }
}
