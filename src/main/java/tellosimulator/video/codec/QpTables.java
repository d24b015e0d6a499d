package tellosimulator.video.codec;

/**
 * All that depends on the QP of a macroblock: quantisers, lambda, and thresholds below which blocks
 * quantise to zero.
 *
 * @param qp QP of luma, 0 to 51
 * @param luma for Inter macroblocks
 * @param chroma for Inter macroblocks, at QPc
 * @param intraLuma for Intra macroblocks
 * @param intraChroma for Intra macroblocks, at QPc
 * @param lambda the Lagrange multiplier of mode decision: what a bit costs in SAD
 * @param lumaZeroSad a 4x4 luma block with a smaller SAD quantises to zero
 * @param chromaZeroSad the same for chroma
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

  /** Documented: H.264, 7.4.5. */
  static final int MAX_QP = 51;

  /**
   * Rounding offsets of the quantiser, in sixths of a step: as in x264 and JM, a wider dead zone
   * for Inter blocks.
   */
  private static final int INTER_ROUNDING_SIXTHS = 1;

  private static final int INTRA_ROUNDING_SIXTHS = 2;

  /**
   * In quantiser steps. Calculated: a nonzero level needs 5/6 of a step, and no coefficient is
   * above 0.4 of the SAD, so below 2.1 there is none; from there to this there hardly ever is.
   */
  private static final double LUMA_ZERO_STEPS = 2.7;

  /**
   * In quantiser steps; lower, as the Hadamard transform of four DC coefficients makes chroma
   * finer.
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
