package tellosimulator.video.codec;

import org.jcodec.codecs.h264.H264Const;

/**
 * How finely coefficients are told at one quality (QP, 0 to 51: six more are half as fine).
 * Immutable tables; all positions are row by row.
 */
final class Quantizer {

  /** Documented: H.264, 8.5.9: corners, centres, and the others. */
  private static final int[][] SCALES = {
    {10, 16, 13}, {11, 18, 14}, {13, 20, 16}, {14, 23, 18}, {16, 25, 20}, {18, 29, 23}
  };

  /** Their inverses times 2^15 and the transform's own scale, as every encoder has them. */
  private static final int[][] FACTORS = {
    {13107, 5243, 8066},
    {11916, 4660, 7490},
    {10082, 4194, 6554},
    {9362, 3647, 5825},
    {8192, 3355, 5243},
    {7282, 2893, 4559}
  };

  private static final int[] ZIGZAG = {0, 1, 4, 8, 5, 2, 3, 6, 9, 12, 13, 10, 7, 11, 14, 15};

  private static final int[] COLOUR_QP = H264Const.QP_SCALE_CR.clone();

  private final int[] factors = new int[16];
  private final int[] scales = new int[16];
  private final int shift;
  private final int rounding;

  /** The step between two levels, where a difference of 1 in a whole block is 4. */
  final double step;

  /**
   * @param qp from 0 to 51
   * @param share how much of a step is added before the rest is cut off, in sixths
   */
  Quantizer(int qp, int share) {
    shift = 15 + qp / 6;
    rounding = (1 << shift) * share / 6;
    step = 0.625 * Math.pow(2, qp / 6.0);
    for (int i = 0; i < 16; i++) {
      int kind = ((i >> 2) & 1) + (i & 1) == 1 ? 2 : i & 1;
      factors[i] = FACTORS[qp % 6][kind];
      scales[i] = SCALES[qp % 6][kind] << (qp / 6);
    }
  }

  /** Where the coefficient is whose level comes at an index. */
  static int place(int index) {
    return ZIGZAG[index];
  }

  /** The quality of the colours that goes with one of luma. */
  static int colourQp(int qp) {
    return COLOUR_QP[qp];
  }

  /**
   * Turns the coefficients of a block into levels, and into what decoders make of these.
   *
   * @param coefficients 16 from offset on
   * @param levels gets 16 from offset on, in zigzag order
   * @param first 1 where the first coefficient goes elsewhere; it and its level become 0
   * @return how many levels are not 0
   */
  int block(int[] coefficients, int[] levels, int offset, int first) {
    int count = 0;
    levels[offset] = 0;
    for (int i = first; i < 16; i++) {
      int place = ZIGZAG[i];
      int coefficient = coefficients[offset + place];
      int sign = coefficient >> 31;
      int level = (((coefficient ^ sign) - sign) * factors[place] + rounding) >> shift;
      if (level != 0) {
        count++;
        level = (level ^ sign) - sign;
      }
      levels[offset + i] = level;
      coefficients[offset + place] = level * scales[place];
    }
    return count;
  }

  /**
   * Turns the first coefficients of all blocks, once more transformed, into levels.
   *
   * @param first the coefficients, in the order in which levels go
   * @return how many levels are not 0
   */
  int first(int[] first, int offset, int length) {
    int count = 0;
    for (int i = offset; i < offset + length; i++) {
      int sign = first[i] >> 31;
      int level = (((first[i] ^ sign) - sign) * factors[0] + 2 * rounding) >> (shift + 1);
      if (level != 0) {
        count++;
      }
      first[i] = (level ^ sign) - sign;
    }
    return count;
  }

  /** What decoders make of a first coefficient of luma in an intra 16 by 16 macroblock. */
  int lumaFirst(int transformed) {
    return (transformed * scales[0] + 2) >> 2;
  }

  /** What decoders make of a first coefficient of colour. */
  int colourFirst(int transformed) {
    return (transformed * scales[0]) >> 1;
  }
}
