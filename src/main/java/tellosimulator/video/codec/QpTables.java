package tellosimulator.video.codec;

/**
 * Everything that depends on the QP of a macroblock: the quantisers, lambda, and the thresholds
 * below which blocks are quantised to zero.
 *
 * @param qp QP of luma, 0 to 51
 * @param luma quantiser for luma in Inter macroblocks
 * @param chroma quantiser for chroma in Inter macroblocks, at QPc
 * @param intraLuma quantiser for luma in Intra macroblocks
 * @param intraChroma quantiser for chroma in Intra macroblocks, at QPc
 * @param lambda the Lagrange multiplier of mode decision: the cost of one bit in SAD
 * @param lumaZeroSad a 4x4 luma block with a smaller SAD is quantised to zero
 * @param chromaZeroSad a 4x4 chroma block with a smaller SAD is quantised to zero
 */
record QpTables(
    int qp,
    Quantizer luma,
    Quantizer chroma,
    Quantizer intraLuma,
    Quantizer intraChroma,
    int lambda,
    int lumaZeroSad,
    int chromaZeroSad) {

  /** The highest QP. Documented: H.264, 7.4.5. */
  static final int MAX_QP = 51;

  /**
   * Rounding offset of the quantiser for Inter blocks, in sixths of a step. As in x264 and JM, the
   * dead zone is wider than for Intra blocks.
   */
  private static final int INTER_ROUNDING_SIXTHS = 1;

  /** Rounding offset of the quantiser for Intra blocks, in sixths of a step. */
  private static final int INTRA_ROUNDING_SIXTHS = 2;

  /**
   * SAD below which a luma block is quantised to zero, in quantiser steps. Calculated: a nonzero
   * level needs a coefficient of at least 5/6 of a step, and no coefficient exceeds 0.4 times the
   * SAD. Therefore, all levels are zero below 2.1 steps, and nearly always between 2.1 steps and
   * this value.
   */
  private static final double LUMA_ZERO_STEPS = 2.7;

  /**
   * SAD below which a chroma block is quantised to zero, in quantiser steps. This threshold is
   * lower than the threshold for luma, because the Hadamard transform of the four DC coefficients
   * makes the quantisation of chroma finer.
   */
  private static final double CHROMA_ZERO_STEPS = 1.5;

  static QpTables of(int qp) {
    int chromaQp = Quantizer.chromaQp(qp);
    Quantizer luma = new Quantizer(qp, INTER_ROUNDING_SIXTHS);
    Quantizer chroma = new Quantizer(chromaQp, INTER_ROUNDING_SIXTHS);
    return new QpTables(
        qp,
        luma,
        chroma,
        new Quantizer(qp, INTRA_ROUNDING_SIXTHS),
        new Quantizer(chromaQp, INTRA_ROUNDING_SIXTHS),
        (int) Math.max(1, Math.round(StrictMath.pow(2, (qp - 12) / 6.0))),
        (int) (LUMA_ZERO_STEPS * luma.stepSize),
        (int) (CHROMA_ZERO_STEPS * chroma.stepSize));
  }
}
