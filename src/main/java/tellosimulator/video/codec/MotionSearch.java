package tellosimulator.video.codec;

/**
 * Finds where a macroblock comes from in the picture before: the best of the vectors nearby in
 * space and time, then small steps downhill, then a fraction of a pixel.
 */
final class MotionSearch {

  /**
   * Decided: a prediction may lie this far outside the picture; the rest of the border is to
   * filter.
   */
  private static final int OUTSIDE = Frame.BORDER - 8;

  /** Decided: steps of one pixel that are gone downhill. */
  private static final int MOST_STEPS = 16;

  private final MotionField field;
  private final Interpolation interpolation = new Interpolation();
  private Samples best = new Samples();
  private Frame reference;
  private Macroblock macroblock;
  private int lowX;
  private int highX;
  private int lowY;
  private int highY;

  /** The best vector up to now in pixels, what it costs, and its differences. */
  private int pixelX;

  private int pixelY;
  private int pixelCost;

  /** What was found, in quarters of a pixel. */
  int x;

  int y;

  /** The sum of absolute differences of luma. */
  int difference;

  /** Differences and what the vector costs. */
  int cost;

  MotionSearch(MotionField field) {
    this.field = field;
  }

  void begin(Frame newReference, Macroblock newMacroblock) {
    reference = newReference;
    macroblock = newMacroblock;
    lowX = -16 * macroblock.column - OUTSIDE;
    highX = 16 * (reference.columns - 1 - macroblock.column) + OUTSIDE;
    lowY = -16 * macroblock.row - OUTSIDE;
    highY = 16 * (reference.rows - 1 - macroblock.row) + OUTSIDE;
  }

  /** Whether a vector in quarters of a pixel points to where there is something. */
  boolean reachable(int vectorX, int vectorY) {
    return vectorX >= 4 * lowX
        && vectorX <= 4 * highX
        && vectorY >= 4 * lowY
        && vectorY <= 4 * highY;
  }

  /** Predicts all of the macroblock. */
  void predict(int vectorX, int vectorY, Samples to) {
    predictLuma(vectorX, vectorY, to);
    predictColour(vectorX, vectorY, to);
  }

  private void predictLuma(int vectorX, int vectorY, Samples to) {
    interpolation.luma(
        reference.luma, 64 * macroblock.column + vectorX, 64 * macroblock.row + vectorY, to);
  }

  void predictColour(int vectorX, int vectorY, Samples to) {
    int fromX = 64 * macroblock.column + vectorX;
    int fromY = 64 * macroblock.row + vectorY;
    interpolation.colour(reference.blue, fromX, fromY, to.bytes, Samples.BLUE);
    interpolation.colour(reference.red, fromX, fromY, to.bytes, Samples.RED);
  }

  /** Searches. */
  void search() {
    pixelCost = Integer.MAX_VALUE;
    int index = macroblock.row * field.columns + macroblock.column;
    tryQuarters(field.expectedX, field.expectedY);
    tryPixel(0, 0);
    if (macroblock.column > 0) {
      tryQuarters(field.x(index - 1), field.y(index - 1));
    }
    if (macroblock.row > 0) {
      tryQuarters(field.x(index - field.columns), field.y(index - field.columns));
    }
    tryQuarters(field.earlierX(index), field.earlierY(index));
    if (macroblock.row + 1 < reference.rows) {
      tryQuarters(field.earlierX(index + field.columns), field.earlierY(index + field.columns));
    }
    descend();
    x = 4 * pixelX;
    y = 4 * pixelY;
    cost = pixelCost;
    predictLuma(x, y, best);
    difference = macroblock.source.lumaDifference(best);
  }

  /** The prediction of what was found; luma only. */
  Samples found() {
    return best;
  }

  private void descend() {
    for (int step = 0; step < MOST_STEPS; step++) {
      int fromX = pixelX;
      int fromY = pixelY;
      tryPixel(fromX - 1, fromY);
      tryPixel(fromX + 1, fromY);
      tryPixel(fromX, fromY - 1);
      tryPixel(fromX, fromY + 1);
      if (pixelX == fromX && pixelY == fromY) {
        return;
      }
    }
  }

  private void tryQuarters(int quartersX, int quartersY) {
    tryPixel(
        Math.max(lowX, Math.min(highX, (quartersX + 2) >> 2)),
        Math.max(lowY, Math.min(highY, (quartersY + 2) >> 2)));
  }

  private void tryPixel(int toX, int toY) {
    if (toX < lowX || toX > highX || toY < lowY || toY > highY) {
      return;
    }
    int newCost = difference(toX, toY) + vectorCost(4 * toX, 4 * toY);
    if (newCost < pixelCost) {
      pixelCost = newCost;
      pixelX = toX;
      pixelY = toY;
    }
  }

  private int vectorCost(int vectorX, int vectorY) {
    return macroblock.quality.lambda()
        * (BitWriter.signedLength(vectorX - field.expectedX)
            + BitWriter.signedLength(vectorY - field.expectedY));
  }

  private int difference(int toX, int toY) {
    Plane plane = reference.luma;
    byte[] pixels = plane.bytes;
    byte[] wanted = macroblock.source.bytes;
    int at = plane.at(16 * macroblock.column + toX, 16 * macroblock.row + toY);
    long sum = 0;
    for (int i = 0; i < Samples.BLUE; i += Samples.STRIDE) {
      sum += Words.differences(Words.get(pixels, at), Words.get(wanted, i));
      sum += Words.differences(Words.get(pixels, at + 8), Words.get(wanted, i + 8));
      at += plane.stride;
    }
    return Words.sum(sum);
  }
}
