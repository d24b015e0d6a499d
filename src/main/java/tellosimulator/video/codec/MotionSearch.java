package tellosimulator.video.codec;

/**
 * Finds where a macroblock comes from in the picture before: the best of the vectors nearby in
 * space and time, then small steps downhill, then a fraction of a pixel.
 */
final class MotionSearch {

  /** Decided: a prediction may lie this far outside the picture; the filter needs the rest. */
  private static final int OUTSIDE = Frame.BORDER - 8;

  /** In pixels. Documented: H.264, table A-1: 512 up or down at level 4.0. */
  private static final int LONGEST = 500;

  /** Decided: steps of one pixel that are gone downhill. */
  private static final int MOST_STEPS = 16;

  /** The differences where no vector may point: more than there can be. */
  private static final int NOWHERE = 1 << 16;

  private final MotionField field;
  private final Interpolation interpolation = new Interpolation();
  private Samples best = new Samples();
  private Samples trial = new Samples();
  private Frame reference;
  private Macroblock macroblock;
  private int lowX;
  private int highX;
  private int lowY;
  private int highY;

  /** The best vector in whole pixels up to now, and what it costs. */
  private int pixelX;

  private int pixelY;
  private int pixelCost;

  /** The differences at this vector and one pixel beside it. */
  private int here;

  private int left;
  private int right;
  private int above;
  private int below;

  /** The vectors in whole pixels that were tried before going downhill. */
  private final int[] tried = new int[8];

  private int tries;

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

  /** Goes on to the next macroblock; nothing is found yet. */
  void begin(Frame newReference, Macroblock newMacroblock) {
    reference = newReference;
    macroblock = newMacroblock;
    lowX = Math.max(-16 * macroblock.column - OUTSIDE, -LONGEST);
    highX = Math.min(16 * (reference.columns - 1 - macroblock.column) + OUTSIDE, LONGEST);
    lowY = Math.max(-16 * macroblock.row - OUTSIDE, -LONGEST);
    highY = Math.min(16 * (reference.rows - 1 - macroblock.row) + OUTSIDE, LONGEST);
    cost = Integer.MAX_VALUE;
  }

  /**
   * Takes the vector of a skipped macroblock, if it points to where there is something.
   *
   * @return whether it does
   */
  boolean trySkip() {
    if (!reachable(field.skipX, field.skipY)) {
      return false;
    }
    tryPart(field.skipX, field.skipY);
    predictColour();
    return true;
  }

  /** Searches for something better. */
  void search() {
    tries = 0;
    pixelCost = Integer.MAX_VALUE;
    int index = macroblock.row * field.columns + macroblock.column;
    tryQuarters(field.expectedX, field.expectedY);
    tryQuarters(0, 0);
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
    refine();
  }

  /** The prediction of what was found, not a copy; only luma before {@link #predictColour}. */
  Samples found() {
    return best;
  }

  /** Predicts the colours too. */
  void predictColour() {
    int fromX = 64 * macroblock.column + x;
    int fromY = 64 * macroblock.row + y;
    interpolation.colour(reference.blue, fromX, fromY, best.bytes, Samples.BLUE);
    interpolation.colour(reference.red, fromX, fromY, best.bytes, Samples.RED);
  }

  private void descend() {
    for (int step = 0; step < MOST_STEPS; step++) {
      int fromX = pixelX;
      int fromY = pixelY;
      left = tryPixel(fromX - 1, fromY);
      right = tryPixel(fromX + 1, fromY);
      above = tryPixel(fromX, fromY - 1);
      below = tryPixel(fromX, fromY + 1);
      if (pixelX == fromX && pixelY == fromY) {
        return;
      }
    }
  }

  /** Compares with what lies between the pixels. */
  private void refine() {
    int partX = 4 * pixelX + lowest(left, here, right);
    int partY = 4 * pixelY + lowest(above, here, below);
    if (pixelCost < cost) {
      tryPart(4 * pixelX, 4 * pixelY);
    }
    tryPart(partX, partY);
  }

  /** Where between three neighbours the lowest is, in quarters from the middle one. */
  private static int lowest(int before, int middle, int after) {
    int bend = before + after - 2 * middle;
    return bend <= 0 ? 0 : Math.max(-2, Math.min(2, Math.round(2f * (before - after) / bend)));
  }

  private boolean reachable(int toX, int toY) {
    return toX >= 4 * lowX && toX <= 4 * highX && toY >= 4 * lowY && toY <= 4 * highY;
  }

  private void tryPart(int toX, int toY) {
    if ((toX == x && toY == y && cost < Integer.MAX_VALUE) || !reachable(toX, toY)) {
      return;
    }
    interpolation.luma(
        reference.luma, 64 * macroblock.column + toX, 64 * macroblock.row + toY, trial);
    int newDifference = macroblock.source.lumaDifference(trial);
    int newCost = newDifference + vectorCost(toX, toY);
    if (newCost < cost) {
      cost = newCost;
      difference = newDifference;
      x = toX;
      y = toY;
      Samples swap = best;
      best = trial;
      trial = swap;
    }
  }

  private void tryQuarters(int quartersX, int quartersY) {
    int toX = Math.max(lowX, Math.min(highX, (quartersX + 2) >> 2));
    int toY = Math.max(lowY, Math.min(highY, (quartersY + 2) >> 2));
    int both = (toX << 16) + toY;
    for (int i = 0; i < tries; i++) {
      if (tried[i] == both) {
        return;
      }
    }
    tried[tries++] = both;
    tryPixel(toX, toY);
  }

  /** Tries a vector in pixels; its sum of absolute differences. */
  private int tryPixel(int toX, int toY) {
    if (toX < lowX || toX > highX || toY < lowY || toY > highY) {
      return NOWHERE;
    }
    int newDifference = difference(toX, toY);
    int newCost = newDifference + vectorCost(4 * toX, 4 * toY);
    if (newCost < pixelCost) {
      pixelCost = newCost;
      here = newDifference;
      pixelX = toX;
      pixelY = toY;
    }
    return newDifference;
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
    for (int i = 0; i < Samples.BLUE; i += 2 * Samples.STRIDE) {
      sum += Words.differences(Words.get(pixels, at), Words.get(wanted, i));
      sum += Words.differences(Words.get(pixels, at + 8), Words.get(wanted, i + 8));
      at += 2 * plane.stride;
    }
    return 2 * Words.sum(sum);
  }
}
