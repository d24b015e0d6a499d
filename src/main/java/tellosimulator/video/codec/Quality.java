package tellosimulator.video.codec;

/**
 * All that hangs on how finely a macroblock is told (QP).
 *
 * @param qp from 0 to 51
 * @param luma where the prediction is from another picture
 * @param colour where the prediction is from another picture
 * @param intraLuma where the prediction is from the same picture
 * @param intraColour where the prediction is from the same picture
 * @param lambda what a bit costs in absolute differences
 * @param quietLuma a block of luma with a smaller sum of absolute differences has no levels
 * @param quietColour the same for colour
 */
record Quality(
    int qp,
    Quantizer luma,
    Quantizer colour,
    Quantizer intraLuma,
    Quantizer intraColour,
    int lambda,
    int quietLuma,
    int quietColour) {

  /** Documented: H.264, 7.4.5. */
  static final int COARSEST = 51;

  /** How much is added before rounding down, in sixths of a step: little between pictures. */
  private static final int INTER_ROUNDING = 1;

  private static final int INTRA_ROUNDING = 2;

  /**
   * In steps. Calculated: a level needs 5/6 of a step, and no coefficient is above 0.4 of the sum,
   * so below 2.1 there is none; from there to this there hardly ever is.
   */
  private static final double QUIET_LUMA = 2.7;

  /** In steps; the first coefficients of four blocks are transformed once more and so finer. */
  private static final double QUIET_COLOUR = 1.5;

  static Quality of(int qp) {
    int colourQp = Quantizer.colourQp(qp);
    Quantizer luma = new Quantizer(qp, INTER_ROUNDING);
    Quantizer colour = new Quantizer(colourQp, INTER_ROUNDING);
    return new Quality(
        qp,
        luma,
        colour,
        new Quantizer(qp, INTRA_ROUNDING),
        new Quantizer(colourQp, INTRA_ROUNDING),
        (int) Math.max(1, Math.round(Math.pow(2, (qp - 12) / 6.0))),
        (int) (QUIET_LUMA * luma.step),
        (int) (QUIET_COLOUR * colour.step));
  }
}
