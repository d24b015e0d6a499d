package tellosimulator.video.codec;

/**
 * Estimates the motion of 16x16 luma blocks by SAD. The search starts from predictors, which are
 * taken from neighbours in space and time. It continues with a small diamond at full samples.
 * Finally, parabolic interpolation of the SADs gives a quarter-sample position.
 */
final class MotionSearch {

  /**
   * Distance by which a prediction may extend beyond the frame [samples]. Decided: the rest of the
   * border is needed for the six-tap filter.
   */
  private static final int MAX_OVERHANG = Frame.BORDER - 8;

  /**
   * Maximum length of a motion vector in each direction [samples]. Documented: H.264, table A-1,
   * allows 512 vertically at level 4.0.
   */
  private static final int MAX_VECTOR = 500;

  /** Maximum number of steps in the diamond search. Decided. */
  private static final int MAX_DESCENT_STEPS = 16;

  /** The SAD assigned to vectors that are not allowed; it is above any real SAD. */
  private static final int OUT_OF_RANGE_SAD = 1 << 16;

  private final MotionField motion;
  private final MotionCompensation compensation = new MotionCompensation();
  private MacroblockSamples best = new MacroblockSamples();
  private MacroblockSamples trial = new MacroblockSamples();
  private Frame reference;
  private Macroblock macroblock;
  private int minX;
  private int maxX;
  private int minY;
  private int maxY;

  /** The horizontal component of the best full-sample vector so far. */
  private int fullPelX;

  /** The vertical component of the best full-sample vector so far. */
  private int fullPelY;

  /** The cost of the best full-sample vector so far. */
  private int fullPelCost;

  /**
   * The SAD at {@link #fullPelX}, {@link #fullPelY}. The fields below are the SADs at the four
   * positions one sample away.
   */
  private int centerSad;

  private int leftSad;
  private int rightSad;
  private int aboveSad;
  private int belowSad;

  /** The predictors that were tried before the diamond search, rounded to full samples. */
  private final int[] candidates = new int[8];

  private int candidateCount;

  /** The horizontal component of the motion vector that was found [quarter samples]. */
  int mvX;

  /** The vertical component of the motion vector that was found [quarter samples]. */
  int mvY;

  /** The SAD of luma at the motion vector. */
  int sad;

  /** The Lagrangian cost of the motion vector: SAD + lambda * bits of mvd. */
  int cost;

  MotionSearch(MotionField motion) {
    this.motion = motion;
  }

  /** Moves on to the next macroblock. */
  void begin(Frame newReference, Macroblock newMacroblock) {
    reference = newReference;
    macroblock = newMacroblock;
    minX = Math.max(-16 * macroblock.mbX - MAX_OVERHANG, -MAX_VECTOR);
    maxX = Math.min(16 * (reference.widthInMbs - 1 - macroblock.mbX) + MAX_OVERHANG, MAX_VECTOR);
    minY = Math.max(-16 * macroblock.mbY - MAX_OVERHANG, -MAX_VECTOR);
    maxY = Math.min(16 * (reference.heightInMbs - 1 - macroblock.mbY) + MAX_OVERHANG, MAX_VECTOR);
    cost = Integer.MAX_VALUE;
  }

  /**
   * Tries the P_Skip vector if it is in range.
   *
   * @return whether it is in range
   */
  boolean tryPSkip() {
    if (!inRange(motion.pSkipMvX, motion.pSkipMvY)) {
      return false;
    }
    trySubpel(motion.pSkipMvX, motion.pSkipMvY);
    predictChroma();
    return true;
  }

  /** Searches for a vector with a lower cost than the best one so far. */
  void search() {
    candidateCount = 0;
    fullPelCost = Integer.MAX_VALUE;
    int index = macroblock.mbY * motion.widthInMbs + macroblock.mbX;
    tryCandidate(motion.mvpX, motion.mvpY);
    tryCandidate(0, 0);
    if (macroblock.mbX > 0) {
      tryCandidate(motion.mvX(index - 1), motion.mvY(index - 1));
    }
    if (macroblock.mbY > 0) {
      tryCandidate(motion.mvX(index - motion.widthInMbs), motion.mvY(index - motion.widthInMbs));
    }
    tryCandidate(motion.previousMvX(index), motion.previousMvY(index));
    if (macroblock.mbY + 1 < reference.heightInMbs) {
      tryCandidate(
          motion.previousMvX(index + motion.widthInMbs),
          motion.previousMvY(index + motion.widthInMbs));
    }
    diamondSearch();
    refineSubpel();
  }

  /**
   * The prediction at the motion vector. The object is reused, and contains only luma until {@link
   * #predictChroma} is called.
   */
  MacroblockSamples prediction() {
    return best;
  }

  /** Predicts Cb and Cr at the motion vector. */
  void predictChroma() {
    int fromX = 64 * macroblock.mbX + mvX;
    int fromY = 64 * macroblock.mbY + mvY;
    compensation.chroma(reference.cb, fromX, fromY, best.bytes, MacroblockSamples.CB);
    compensation.chroma(reference.cr, fromX, fromY, best.bytes, MacroblockSamples.CR);
  }

  private void diamondSearch() {
    for (int step = 0; step < MAX_DESCENT_STEPS; step++) {
      int fromX = fullPelX;
      int fromY = fullPelY;
      leftSad = tryFullPel(fromX - 1, fromY);
      rightSad = tryFullPel(fromX + 1, fromY);
      aboveSad = tryFullPel(fromX, fromY - 1);
      belowSad = tryFullPel(fromX, fromY + 1);
      if (fullPelX == fromX && fullPelY == fromY) {
        return;
      }
    }
  }

  /**
   * Compares the full-sample vector with the quarter-sample vector at the minima of two parabolas,
   * one for each direction.
   */
  private void refineSubpel() {
    int subpelX = 4 * fullPelX + parabolaMinimum(leftSad, centerSad, rightSad);
    int subpelY = 4 * fullPelY + parabolaMinimum(aboveSad, centerSad, belowSad);
    if (fullPelCost < cost) {
      trySubpel(4 * fullPelX, 4 * fullPelY);
    }
    trySubpel(subpelX, subpelY);
  }

  /**
   * Returns the minimum of the parabola through three neighbouring SADs, as a distance from the
   * middle one [quarter samples].
   */
  private static int parabolaMinimum(int before, int middle, int after) {
    int curvature = before + after - 2 * middle;
    return curvature <= 0
        ? 0
        : Math.max(-2, Math.min(2, Math.round(2f * (before - after) / curvature)));
  }

  private boolean inRange(int toX, int toY) {
    return toX >= 4 * minX && toX <= 4 * maxX && toY >= 4 * minY && toY <= 4 * maxY;
  }

  private void trySubpel(int toX, int toY) {
    if ((toX == mvX && toY == mvY && cost < Integer.MAX_VALUE) || !inRange(toX, toY)) {
      return;
    }
    compensation.luma(reference.luma, 64 * macroblock.mbX + toX, 64 * macroblock.mbY + toY, trial);
    int newSad = macroblock.source.lumaSad(trial);
    int newCost = newSad + mvdCost(toX, toY);
    if (newCost < cost) {
      cost = newCost;
      sad = newSad;
      mvX = toX;
      mvY = toY;
      MacroblockSamples swap = best;
      best = trial;
      trial = swap;
    }
  }

  /** Tries a predictor, rounded to full samples, unless it has already been tried. */
  private void tryCandidate(int quarterPelX, int quarterPelY) {
    int toX = Math.max(minX, Math.min(maxX, (quarterPelX + 2) >> 2));
    int toY = Math.max(minY, Math.min(maxY, (quarterPelY + 2) >> 2));
    int packed = (toX << 16) + toY;
    for (int i = 0; i < candidateCount; i++) {
      if (candidates[i] == packed) {
        return;
      }
    }
    candidates[candidateCount++] = packed;
    tryFullPel(toX, toY);
  }

  /** Tries a full-sample vector and returns its SAD. */
  private int tryFullPel(int toX, int toY) {
    if (toX < minX || toX > maxX || toY < minY || toY > maxY) {
      return OUT_OF_RANGE_SAD;
    }
    int newSad = subsampledSad(toX, toY);
    int newCost = newSad + mvdCost(4 * toX, 4 * toY);
    if (newCost < fullPelCost) {
      fullPelCost = newCost;
      centerSad = newSad;
      fullPelX = toX;
      fullPelY = toY;
    }
    return newSad;
  }

  /** Returns the cost of the bits of mvd: lambda times their number. */
  private int mvdCost(int vectorX, int vectorY) {
    return macroblock.tables.lambda()
        * (BitWriter.seLength(vectorX - motion.mvpX) + BitWriter.seLength(vectorY - motion.mvpY));
  }

  /** Returns twice the SAD of every second row, as an estimate for all rows. */
  private int subsampledSad(int toX, int toY) {
    Plane plane = reference.luma;
    byte[] samples = plane.bytes;
    byte[] source = macroblock.source.bytes;
    int at = plane.offset(16 * macroblock.mbX + toX, 16 * macroblock.mbY + toY);
    long sum = 0;
    for (int i = 0; i < MacroblockSamples.CB; i += 2 * MacroblockSamples.STRIDE) {
      sum += Swar.absoluteDifferences(Swar.load(samples, at), Swar.load(source, i));
      sum += Swar.absoluteDifferences(Swar.load(samples, at + 8), Swar.load(source, i + 8));
      at += 2 * plane.stride;
    }
    return 2 * Swar.horizontalSum(sum);
  }
}
