package tellosimulator.video.codec;

/**
 * Chooses the QP of each frame, so that the stream keeps to its bit rate at even quality.
 *
 * <p>It works with the complexity of a frame: its bits at QP 0, which change slowly from frame to
 * frame; six more QP halve the bits. The complexities of the last IDR frame and of the last P
 * frames give the one QP at which a whole GOP fits the rate; the debt of earlier frames is soon
 * repaid. A frame that takes far more than expected, as after a cut, gets a higher QP from
 * macroblock row to row.
 */
final class RateControl {

  /**
   * Decided: nobody sees more. Measured: P frames of a still scene take up to 2 kB for ever, at 18
   * nothing, but are 2 dB better. Below 10 a level could exceed its longest CAVLC code.
   */
  private static final int MIN_QP = 15;

  /** Decided: IDR frames are finer, since the P frames after them are predicted from them. */
  private static final int IDR_QP_OFFSET = 3;

  /** Decided: P frames may be finer still where hardly anything changes. */
  private static final int MAX_P_QP_GAIN = 14;

  /** Decided: so much may QP rise from frame to frame in one scene. */
  private static final int MAX_QP_RISE = 2;

  /**
   * Decided: so much does it fall where it could fall by more. Measured: finest in a still scene.
   */
  private static final int MAX_QP_FALL = 4;

  /** Decided: smaller changes of QP are not followed. */
  private static final double QP_HYSTERESIS = 0.8;

  /** Decided: QP does not swing from row to row, but a frame of only noise gets coarse in time. */
  private static final int ROW_QP_STEP = 1;

  /** Bits of an IDR frame, in average frames. Decided: a third of the second that it begins. */
  private static final double IDR_FRAME_LIMIT = 10;

  /** Of a GOP's bits. Decided: half is left for the P frames. */
  private static final double MAX_IDR_SHARE = 0.5;

  /**
   * Bits of a P frame, in average frames. Decided: as much as the network has to carry after a cut.
   */
  private static final double P_FRAME_LIMIT = 4;

  /** Weight of a new complexity in the running mean, if it is higher. Decided: soon. */
  private static final double RISE_WEIGHT = 0.4;

  /** Weight of a new complexity in the running mean, if it is lower. Decided: less soon. */
  private static final double FALL_WEIGHT = 0.2;

  /** The same, if it is below {@link #STILL_SHARE} of the mean. Decided: at once. */
  private static final double STILL_WEIGHT = 0.5;

  /**
   * Frames of a still scene have less than this share of the complexity before. Measured: by a
   * stop.
   */
  private static final double STILL_SHARE = 0.1;

  /**
   * Decided: a frame counts at most that many times the mean; a cut says nothing of the next frame.
   */
  private static final double MAX_COMPLEXITY_RISE = 2;

  /** Decided: debt is repaid, or savings are spent, within this time [s]. */
  private static final double REPAY_SECONDS = 0.5;

  /** Decided: so many seconds of unused bits are saved. */
  private static final double MAX_SAVED_SECONDS = 0.25;

  /** Decided: so many seconds of bits are repaid. */
  private static final double MAX_OWED_SECONDS = 1;

  /** Complexity of an IDR macroblock, about. Measured: in the default room. */
  private static final double INITIAL_IDR_COMPLEXITY = 6000;

  /** Complexity of P frames, as a share of that of IDR frames, about. Measured: in slow flight. */
  private static final double INITIAL_P_SHARE = 0.15;

  private final int heightInMbs;
  private double bitsPerFrame;
  private double frameRate;

  /** Bits at QP 0. */
  private double idrComplexity;

  private double pComplexity;

  /** Bits sent beyond the rate; negative if fewer were sent. */
  private double debt;

  /** Bits of the last IDR frame beyond an average frame. */
  private double idrExcess;

  private int gopLength;
  private int framesInGop;
  private boolean unconstrained = true;
  private boolean idr;
  private int qp = 30;
  private int pQp = 30;
  private int idrQp = 30;
  private long qpSum;
  private double frameLimit;

  /**
   * @param macroblocks of a frame
   * @param heightInMbs rows of macroblocks
   */
  RateControl(int macroblocks, int heightInMbs) {
    this.heightInMbs = heightInMbs;
    idrComplexity = INITIAL_IDR_COMPLEXITY * macroblocks;
    pComplexity = INITIAL_P_SHARE * idrComplexity;
    setRate(30, 2_500_000);
  }

  /**
   * Sets the rate from the next frame on. What was sent before no longer counts, and the next frame
   * may be as large as ever.
   */
  void setRate(int framesPerSecond, int bitsPerSecond) {
    frameRate = framesPerSecond;
    bitsPerFrame = (double) bitsPerSecond / framesPerSecond;
    gopLength = framesPerSecond;
    framesInGop = 0;
    debt = 0;
    idrExcess = 0;
    unconstrained = true;
  }

  /** Begins a frame; the QP of its first row. */
  int beginFrame(boolean newIdr) {
    idr = newIdr;
    if (idr) {
      gopLength = framesInGop > 0 ? framesInGop : gopLength;
      framesInGop = 0;
      idrExcess = 0;
    }
    double budget = Math.max(bitsPerFrame / 3, bitsPerFrame - owed() / (REPAY_SECONDS * frameRate));
    if (idr) {
      idrQp = clip(idealIdrQp(budget));
      qp = idrQp;
    } else {
      double share = Math.max(bitsPerFrame / 3, budget - idrExcess / pFrames());
      pQp = pQpTowards(Math.max(idrQp - MAX_P_QP_GAIN, qpFor(pComplexity, share)));
      qp = pQp;
      unconstrained = false;
    }
    framesInGop++;
    frameLimit = idr ? idrLimit() : P_FRAME_LIMIT * bitsPerFrame;
    qpSum = 0;
    return qp;
  }

  private double idrLimit() {
    return bitsPerFrame * Math.min(IDR_FRAME_LIMIT, MAX_IDR_SHARE * gopLength);
  }

  /** P frames in a GOP. */
  private double pFrames() {
    return Math.max(1, gopLength - 1);
  }

  /**
   * The debt, but for the part of the IDR frame's excess that the rest of the GOP has yet to repay.
   */
  private double owed() {
    return debt - idrExcess * Math.max(0, gopLength - framesInGop) / pFrames();
  }

  /** The QP at which a GOP fits the rate, with finer IDR than P frames. */
  private double idealIdrQp(double budget) {
    double gopComplexity =
        idrComplexity * StrictMath.pow(2, IDR_QP_OFFSET / 6.0) + pFrames() * pComplexity;
    double ideal = qpFor(gopComplexity, (1 + pFrames()) * budget) - IDR_QP_OFFSET;
    return Math.max(ideal, qpFor(idrComplexity, idrLimit()));
  }

  /** Follows the target with hysteresis: a change that is taken back at once costs most. */
  private int pQpTowards(double target) {
    double change = target - pQp;
    if (unconstrained) {
      return clip(target);
    }
    if (change < -QP_HYSTERESIS) {
      return clip(pQp - (change < -MAX_QP_FALL ? MAX_QP_FALL : 1));
    }
    return change > QP_HYSTERESIS ? clip(pQp + Math.min(MAX_QP_RISE, change)) : pQp;
  }

  private static int clip(double qp) {
    return (int) Math.max(MIN_QP, Math.min(QpTables.MAX_QP, Math.round(qp)));
  }

  private static double qpFor(double bits, double target) {
    return 6 / StrictMath.log(2) * StrictMath.log(bits / target);
  }

  /**
   * The QP of the next row.
   *
   * @param rows rows that are coded
   * @param bits of these
   */
  int rowCoded(int rows, int bits) {
    qpSum += qp;
    if (bits > frameLimit * (rows + 2) / heightInMbs) {
      qp = Math.min(QpTables.MAX_QP, qp + ROW_QP_STEP);
    }
    return qp;
  }

  /** Ends a frame of that size [bit]. */
  void endFrame(int bits) {
    double complexity = bits * StrictMath.pow(2, (double) qpSum / heightInMbs / 6);
    double excess = bits - bitsPerFrame;
    if (idr) {
      idrComplexity = complexity;
      idrExcess = excess;
    } else {
      updateComplexity(Math.min(complexity, MAX_COMPLEXITY_RISE * pComplexity));
    }
    double bitsPerSecond = bitsPerFrame * frameRate;
    debt =
        Math.max(
            -MAX_SAVED_SECONDS * bitsPerSecond,
            Math.min(MAX_OWED_SECONDS * bitsPerSecond, debt + excess));
  }

  private void updateComplexity(double complexity) {
    double share = complexity < STILL_SHARE * pComplexity ? STILL_WEIGHT : FALL_WEIGHT;
    pComplexity += (complexity > pComplexity ? RISE_WEIGHT : share) * (complexity - pComplexity);
  }
}
