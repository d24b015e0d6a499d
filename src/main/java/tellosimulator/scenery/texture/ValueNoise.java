package tellosimulator.scenery.texture;

import java.util.SplittableRandom;

/**
 * Value noise: a number for each texel in a square that tiles without a seam. The numbers are
 * interpolated smoothly between random values on a lattice. Equal seeds give equal numbers. Not
 * thread-safe.
 */
public final class ValueNoise {

  private final int size;

  /**
   * The numbers row by row, because a small heap has room for many rows, but not for large arrays.
   */
  private final float[][] rows;

  /**
   * Creates noise that is zero everywhere.
   *
   * @param size side length of the square [texels], a power of two
   */
  public ValueNoise(int size) {
    this.size = size;
    rows = new float[size][size];
  }

  /**
   * The number of random values across and down. Each must divide the side length of the square.
   */
  public record Lattice(int across, int down) {}

  /**
   * Adds an octave of noise.
   *
   * @param amplitude maximum absolute value of the random values
   */
  public ValueNoise addOctave(Lattice lattice, double amplitude, long seed) {
    float[] random = randomValues(lattice, amplitude, seed);
    float[] row = new float[lattice.across];
    float[] slope = slope(size / lattice.across);
    for (int y = 0; y < size; y++) {
      double down = (double) y * lattice.down / size;
      int above = (int) down;
      float part = smoothstep(down - above);
      for (int i = 0; i < lattice.across; i++) {
        float high = random[above * lattice.across + i];
        float low = random[(above + 1) % lattice.down * lattice.across + i];
        row[i] = high + (low - high) * part;
      }
      addRow(rows[y], row, slope);
    }
    return this;
  }

  /** Returns the noise at a texel. Outside the square, the noise repeats. */
  public float at(int x, int y) {
    return rows[y & size - 1][x & size - 1];
  }

  private static void addRow(float[] values, float[] row, float[] slope) {
    int texel = 0;
    for (int i = 0; i < row.length; i++) {
      float left = row[i];
      float rise = row[(i + 1) % row.length] - left;
      for (float part : slope) {
        values[texel++] += left + rise * part;
      }
    }
  }

  private static float[] slope(int steps) {
    float[] slope = new float[steps];
    for (int i = 0; i < steps; i++) {
      slope[i] = smoothstep((double) i / steps);
    }
    return slope;
  }

  private static float[] randomValues(Lattice lattice, double amplitude, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    float[] values = new float[lattice.across * lattice.down];
    for (int i = 0; i < values.length; i++) {
      values[i] = (float) (amplitude * (2 * random.nextDouble() - 1));
    }
    return values;
  }

  /** Smoothstep: rises from 0 to 1 with zero slope at both ends. */
  private static float smoothstep(double part) {
    return (float) (part * part * (3 - 2 * part));
  }
}
