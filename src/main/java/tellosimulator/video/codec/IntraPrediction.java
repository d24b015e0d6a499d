package tellosimulator.video.codec;

/**
 * Predictions of a macroblock from its neighbours in the same picture, as decoders see them: the
 * column at its left and the row above it.
 */
final class IntraPrediction {

  /** How pixels come from the neighbours. */
  private enum Mode {
    /** The row above goes on downwards. */
    DOWN(0, 2),
    /** The column at the left goes on to the right. */
    ACROSS(1, 1),
    /** The mean of both. */
    MEAN(2, 0),
    /** A plane through both. */
    PLANE(3, 3);

    /** H.264, table 8-4. */
    final int luma;

    /** H.264, table 8-5. */
    final int colour;

    Mode(int luma, int colour) {
      this.luma = luma;
      this.colour = colour;
    }

    /** That of a number in luma. */
    static Mode ofLuma(int number) {
      return switch (number) {
        case 0 -> DOWN;
        case 1 -> ACROSS;
        case 2 -> MEAN;
        default -> PLANE;
      };
    }

    boolean possible(Macroblock macroblock) {
      return switch (this) {
        case DOWN -> macroblock.row > 0;
        case ACROSS -> macroblock.column > 0;
        case MEAN -> true;
        case PLANE -> macroblock.row > 0 && macroblock.column > 0;
      };
    }
  }

  private static final int STRIDE = Samples.STRIDE;

  private static final Mode[] MODES = Mode.values();

  /**
   * Of so many rows one is compared. Measured: key pictures take 2 % less time than with all rows
   * (and the plane only where some promise it), and are as good to 0.1 dB.
   */
  private static final int SAMPLED = 4;

  private static final int FIRST_SAMPLE = 2;

  private final Samples trial = new Samples();

  /**
   * Finds the best prediction of luma and says which in the macroblock.
   *
   * @param frame the picture as decoders see it, as far as it is coded
   * @param best gets the prediction
   * @return the sum of absolute differences, about
   */
  int luma(Frame frame, Macroblock macroblock, Samples best) {
    int least = Integer.MAX_VALUE;
    Mode found = Mode.MEAN;
    for (Mode mode : MODES) {
      if (mode.possible(macroblock)) {
        luma(frame.luma, macroblock, mode, FIRST_SAMPLE, SAMPLED, trial.bytes);
        int difference = macroblock.source.lumaDifference(trial, FIRST_SAMPLE, SAMPLED);
        if (difference < least) {
          least = difference;
          found = mode;
        }
      }
    }
    luma(frame.luma, macroblock, found, 0, 1, best.bytes);
    macroblock.lumaMode = found.luma;
    return SAMPLED * least;
  }

  /**
   * Finds the better prediction of both colours, the mean or in the same way as luma, and says
   * which in the macroblock. Measured: with all four, key pictures take 4 % longer, and are as good
   * to 0.1 dB.
   *
   * @param best gets the prediction
   */
  void colour(Frame frame, Macroblock macroblock, Samples best) {
    int mean = colour(frame, macroblock, Mode.MEAN, best);
    Mode asLuma = Mode.ofLuma(macroblock.lumaMode);
    if (asLuma != Mode.MEAN && colour(frame, macroblock, asLuma, trial) < mean) {
      System.arraycopy(trial.bytes, Samples.BLUE, best.bytes, Samples.BLUE, Samples.COLOURS);
      macroblock.colourMode = asLuma.colour;
    } else {
      macroblock.colourMode = Mode.MEAN.colour;
    }
  }

  private int colour(Frame frame, Macroblock macroblock, Mode mode, Samples to) {
    colour(frame.blue, macroblock, mode, to.bytes, Samples.BLUE);
    colour(frame.red, macroblock, mode, to.bytes, Samples.RED);
    return macroblock.source.colourDifference(to);
  }

  /** Predicts some rows. */
  private static void luma(
      Plane from, Macroblock macroblock, Mode mode, int first, int step, byte[] to) {
    int at = from.at(16 * macroblock.column, 16 * macroblock.row);
    switch (mode) {
      case DOWN -> {
        long above = Words.get(from.bytes, at - from.stride);
        fill(above, Words.get(from.bytes, at - from.stride + 8), first, step, to);
      }
      case ACROSS -> across(from, at, first, step, to);
      case MEAN -> {
        long mean = Words.fill(lumaMean(from, at, macroblock));
        fill(mean, mean, first, step, to);
      }
      case PLANE -> PlanePrediction.predict(from, at, 16, first, step, to, 0);
    }
  }

  private static void fill(long left, long right, int first, int step, byte[] to) {
    for (int i = first * STRIDE; i < Samples.BLUE; i += step * STRIDE) {
      Words.put(to, i, left);
      Words.put(to, i + 8, right);
    }
  }

  private static void across(Plane from, int at, int first, int step, byte[] to) {
    for (int y = first; y < 16; y += step) {
      long word = Words.fill(from.bytes[at + from.stride * y - 1]);
      Words.put(to, STRIDE * y, word);
      Words.put(to, STRIDE * y + 8, word);
    }
  }

  private static void colour(Plane from, Macroblock macroblock, Mode mode, byte[] pixels, int to) {
    int at = from.at(8 * macroblock.column, 8 * macroblock.row);
    switch (mode) {
      case DOWN -> down(from, at, pixels, to);
      case ACROSS -> across(from, at, pixels, to);
      case MEAN -> colourMeans(from, at, macroblock, pixels, to);
      case PLANE -> PlanePrediction.predict(from, at, 8, 0, 1, pixels, to);
    }
  }

  private static void down(Plane from, int at, byte[] to, int offset) {
    long above = Words.get(from.bytes, at - from.stride);
    for (int y = 0; y < 8; y++) {
      Words.put(to, offset + STRIDE * y, above);
    }
  }

  private static void across(Plane from, int at, byte[] to, int offset) {
    for (int y = 0; y < 8; y++) {
      Words.put(to, offset + STRIDE * y, Words.fill(from.bytes[at + from.stride * y - 1]));
    }
  }

  private static int lumaMean(Plane from, int at, Macroblock macroblock) {
    boolean above = macroblock.row > 0;
    boolean left = macroblock.column > 0;
    int sum = (above ? sumAbove(from, at, 16) : 0) + (left ? sumLeft(from, at, 16) : 0);
    if (above && left) {
      return (sum + 16) >> 5;
    }
    return above || left ? (sum + 8) >> 4 : 128;
  }

  /** Each quarter has a mean of its own: those in the corners of both, the others of the nearer. */
  private static void colourMeans(
      Plane from, int at, Macroblock macroblock, byte[] pixels, int to) {
    boolean above = macroblock.row > 0;
    boolean left = macroblock.column > 0;
    for (int half = 0; half < 2; half++) {
      int below = at + 4 * half * from.stride;
      int leftSum = left ? sumLeft(from, below, 4) : 0;
      int first;
      int second;
      int aboveSum = above ? sumAbove(from, at, 4) : 0;
      int besideSum = above ? sumAbove(from, at + 4, 4) : 0;
      if (above && left) {
        first = half == 0 ? (aboveSum + leftSum + 4) >> 3 : (leftSum + 2) >> 2;
        second = half == 0 ? (besideSum + 2) >> 2 : (besideSum + leftSum + 4) >> 3;
      } else {
        first = above || left ? (aboveSum + leftSum + 2) >> 2 : 128;
        second = above || left ? (besideSum + leftSum + 2) >> 2 : 128;
      }
      long word = (Words.fill(first) & 0xFFFF_FFFFL) | (Words.fill(second) << 32);
      for (int y = 4 * half; y < 4 * half + 4; y++) {
        Words.put(pixels, to + STRIDE * y, word);
      }
    }
  }

  private static int sumAbove(Plane from, int at, int length) {
    int sum = 0;
    for (int i = at - from.stride; i < at - from.stride + length; i++) {
      sum += from.bytes[i] & 0xFF;
    }
    return sum;
  }

  private static int sumLeft(Plane from, int at, int length) {
    int sum = 0;
    for (int y = 0; y < length; y++) {
      sum += from.bytes[at - 1 + y * from.stride] & 0xFF;
    }
    return sum;
  }
}
