package tellosimulator.scenery.texture;

import java.util.SplittableRandom;

/**
 * Value noise: a number for each texel of a square that tiles without a seam, interpolated smoothly
 * between random values on a lattice. Equal seeds give equal numbers. For one thread.
 */
public final class ValueNoise {

  private final int size;
  private final float[] values;

  /**
   * All zero.
   *
   * @param size edge of the square [texels], a power of two
   */
  public ValueNoise(int size) {
    this.size = size;
    values = new float[size * size];
  }

  /** How many random values there are across and down; they divide the size. */
  public record Lattice(int across, int down) {}

  /**
   * Adds an octave of noise.
   *
   * @param amplitude the random values are from minus to plus this
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
      addRow(y, row, slope);
    }
    return this;
  }

  /** The noise at a texel; beyond the square it repeats. */
  public float at(int x, int y) {
    return values[(y & size - 1) * size + (x & size - 1)];
  }

  private void addRow(int y, float[] row, float[] slope) {
    int texel = y * size;
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

  /** Smoothstep: from 0 to 1, level at both ends. */
  private static float smoothstep(double part) {
    return (float) (part * part * (3 - 2 * part));
  }
}
