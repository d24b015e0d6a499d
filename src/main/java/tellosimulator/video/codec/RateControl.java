package tellosimulator.video.codec;

/**
 * Chooses the QP of each frame, so that the stream keeps its bit rate at an even quality.
 *
 * <p>The choice is based on the complexity of a frame, which is the number of bits that it would
 * take at QP 0. The complexity changes slowly from frame to frame, and raising the QP by six halves
 * the number of bits. The complexities of the last IDR frame and of the last P frames determine the
 * QP at which a whole GOP fits the bit rate. The bits by which earlier frames exceeded the rate
 * (the debt) are soon repaid by smaller frames. If a frame takes far more bits than expected, as
 * after a cut, its QP rises from one macroblock row to the next.
 */
final class RateControl {

  /**
   * Lowest QP. Decided: better quality is not visible. Measured: at this QP, the P frames of a
   * still scene take up to 2 kB each, indefinitely; at QP 18 they take nothing, but the quality is
   * 2 dB lower. Below QP 10, a level could exceed its longest CAVLC code.
   */
  private static final int MIN_QP = 15;

  /**
   * Difference between the QP of P frames and the QP of IDR frames. Decided: IDR frames are finer,
   * because subsequent P frames are predicted from them.
   */
  private static final int IDR_QP_OFFSET = 3;

  /**
   * Maximum amount by which the QP of P frames may be below the QP of the IDR frame. Decided: P
   * frames may be even finer than the IDR frame if hardly anything changes.
   */
  private static final int MAX_P_QP_GAIN = 14;

  /** Maximum increase in QP from frame to frame within a scene. Decided. */
  private static final int MAX_QP_RISE = 2;

  /**
   * Decrease in QP from one frame to the next if the target is lower by more than this value.
   * Decided. Measured: this value gives the finest pictures in a still scene.
   */
  private static final int MAX_QP_FALL = 4;

  /** A change in the target QP is ignored if it is not greater than this value. Decided. */
  private static final double QP_HYSTERESIS = 0.8;

  /**
   * Increase in QP from row to row while the frame is too large. Decided: the QP does not jump
   * between rows, but a frame of pure noise becomes coarse soon enough.
   */
  private static final int ROW_QP_STEP = 1;

  /**
   * Maximum number of bits of an IDR frame, as a multiple of the average frame. Decided: at 30
   * frames a second, a third of the bits of one second.
   */
  private static final double IDR_FRAME_LIMIT = 10;

  /**
   * Maximum share of a GOP's bits that its IDR frame takes. Decided: half is left for the P frames.
   */
  private static final double MAX_IDR_SHARE = 0.5;

  /**
   * Maximum number of bits of a P frame, as a multiple of the average frame. Decided: the most that
   * the network should have to carry after a cut.
   */
  private static final double P_FRAME_LIMIT = 4;

  /**
   * Weight of a new complexity in the running mean if it is higher than the mean. Decided: the mean
   * rises quickly.
   */
  private static final double RISE_WEIGHT = 0.4;

  /**
   * Weight of a new complexity in the running mean if it is lower than the mean. Decided: the mean
   * falls more slowly than it rises.
   */
  private static final double FALL_WEIGHT = 0.2;

  /**
   * Weight of a new complexity that is below {@link #STILL_SHARE} of the mean. Decided: the mean
   * falls fastest when the scene becomes still.
   */
  private static final double STILL_WEIGHT = 0.5;

  /**
   * Share of the mean complexity below which a frame counts as part of a still scene. Measured: the
   * complexity falls below this share when the drone stops.
   */
  private static final double STILL_SHARE = 0.1;

  /**
   * Maximum complexity with which a frame enters the running mean, as a multiple of the mean.
   * Decided: the complexity at a cut does not predict the complexity of the next frame.
   */
  private static final double MAX_COMPLEXITY_RISE = 2;

  /** Time within which a debt is repaid or savings are spent [s]. Decided. */
  private static final double REPAY_SECONDS = 0.5;

  /** Maximum number of saved bits, expressed as the time it takes to send them [s]. Decided. */
  private static final double MAX_SAVED_SECONDS = 0.25;

  /** Maximum debt, expressed as the time it takes to send its bits [s]. Decided. */
  private static final double MAX_OWED_SECONDS = 1;

  /** Initial estimate of the complexity of an IDR macroblock. Measured: in the default room. */
  private static final double INITIAL_IDR_COMPLEXITY = 6000;

  /**
   * Initial estimate of the complexity of P frames, relative to the complexity of IDR frames.
   * Measured: in slow flight.
   */
  private static final double INITIAL_P_SHARE = 0.15;

  private final int heightInMbs;
  private double bitsPerFrame;
  private double frameRate;

  /** The complexity of an IDR frame [bits at QP 0]. */
  private double idrComplexity;

  /** The complexity of a P frame [bits at QP 0]. */
  private double pComplexity;

  /** Number of bits sent in excess of the rate; negative if fewer were sent. */
  private double debt;

  /** Number of bits by which the last IDR frame exceeded an average frame. */
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
   * Creates a rate control with a default rate.
   *
   * @param macroblocks number of macroblocks in a frame
   * @param heightInMbs number of macroblock rows
   */
  RateControl(int macroblocks, int heightInMbs) {
    this.heightInMbs = heightInMbs;
    idrComplexity = INITIAL_IDR_COMPLEXITY * macroblocks;
    pComplexity = INITIAL_P_SHARE * idrComplexity;
    setRate(30, 2_500_000);
  }

  /**
   * Sets the bit rate from the next frame on. Earlier frames no longer count, and the QP may change
   * by any amount at once.
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

  /** Begins a frame and returns the QP of its first row. */
  int beginFrame(boolean newIdr) {
    idr = newIdr;
    if (idr) {
      gopLength = framesInGop > 0 ? framesInGop : gopLength;
      framesInGop = 0;
      idrExcess = 0;
    }
    double budget =
        Math.max(bitsPerFrame / 3, bitsPerFrame - hasPending() / (REPAY_SECONDS * frameRate));
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

  /** The number of P frames in a GOP. */
  private double pFrames() {
    return Math.max(1, gopLength - 1);
  }

  /**
   * Returns the debt, excluding the part of the IDR frame's excess that is to be repaid by the rest
   * of the GOP.
   */
  private double hasPending() {
    return debt - idrExcess * Math.max(0, gopLength - framesInGop) / pFrames();
  }

  /**
   * Returns the QP with which the IDR frame must be encoded so that a whole GOP fits the bit rate,
   * given that IDR frames are finer than P frames.
   */
  private double idealIdrQp(double budget) {
    double gopComplexity =
        idrComplexity * StrictMath.pow(2, IDR_QP_OFFSET / 6.0) + pFrames() * pComplexity;
    double ideal = qpFor(gopComplexity, (1 + pFrames()) * budget) - IDR_QP_OFFSET;
    return Math.max(ideal, qpFor(idrComplexity, idrLimit()));
  }

  /**
   * Returns the next QP of P frames. It follows a target with hysteresis, because the most
   * expensive changes are changes that are reverted immediately.
   */
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
   * Returns the QP of the next row.
   *
   * @param rows number of rows coded so far
   * @param bits number of bits that these rows take
   */
  int rowCoded(int rows, int bits) {
    qpSum += qp;
    if (bits > frameLimit * (rows + 2) / heightInMbs) {
      qp = Math.min(QpTables.MAX_QP, qp + ROW_QP_STEP);
    }
    return qp;
  }

  /**
   * Ends a frame.
   *
   * @param bits the size of the frame [bit]
   */
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
