package tellosimulator.scenery.paint;

import java.util.SplittableRandom;

/**
 * A number for each pixel of a square that repeats without a seam: what makes wood, stone and paint
 * uneven. The same seed always gives the same numbers. For one thread.
 */
public final class Field {

  private final int size;
  private final float[] values;

  /**
   * All zero.
   *
   * @param size edge of the square [pixels], a power of two
   */
  public Field(int size) {
    this.size = size;
    values = new float[size * size];
  }

  /** How many humps and hollows there are in a row and in a column; they divide the size. */
  public record Grain(int across, int down) {}

  /**
   * Adds soft humps and hollows.
   *
   * @param weight how high they are: from minus to plus this
   */
  public Field rough(Grain grain, double weight, long seed) {
    float[] knots = knots(grain, weight, seed);
    float[] row = new float[grain.across];
    float[] slope = slope(size / grain.across);
    for (int y = 0; y < size; y++) {
      double down = (double) y * grain.down / size;
      int above = (int) down;
      float part = soft(down - above);
      for (int i = 0; i < grain.across; i++) {
        float high = knots[above * grain.across + i];
        float low = knots[(above + 1) % grain.down * grain.across + i];
        row[i] = high + (low - high) * part;
      }
      addRow(y, row, slope);
    }
    return this;
  }

  /** The number of a pixel; beyond the square it repeats. */
  public float at(int x, int y) {
    return values[(y & size - 1) * size + (x & size - 1)];
  }

  private void addRow(int y, float[] row, float[] slope) {
    int pixel = y * size;
    for (int i = 0; i < row.length; i++) {
      float left = row[i];
      float rise = row[(i + 1) % row.length] - left;
      for (float part : slope) {
        values[pixel++] += left + rise * part;
      }
    }
  }

  private static float[] slope(int steps) {
    float[] slope = new float[steps];
    for (int i = 0; i < steps; i++) {
      slope[i] = soft((double) i / steps);
    }
    return slope;
  }

  private static float[] knots(Grain grain, double weight, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    float[] knots = new float[grain.across * grain.down];
    for (int i = 0; i < knots.length; i++) {
      knots[i] = (float) (weight * (2 * random.nextDouble() - 1));
    }
    return knots;
  }

  /** From 0 to 1 without an edge at either end. */
  private static float soft(double part) {
    return (float) (part * part * (3 - 2 * part));
  }
}
