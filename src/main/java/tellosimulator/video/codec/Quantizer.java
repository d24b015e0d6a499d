package tellosimulator.video.codec;

import org.jcodec.codecs.h264.H264Const;

/**
 * How finely coefficients are told at one quality (QP, 0 to 51: six more are half as fine).
 * Immutable tables; coefficients are in zigzag order.
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

  /** Half of a lane. */
  private static final int HALF = 0x8000;

  private static final long HALVES = Words.lanes(HALF);

  private final int[] factors = new int[16];
  private final int[] scales = new int[16];

  /** By column: how large a coefficient may be that has no level, plus half of a lane. */
  private final long[] limits = new long[4];

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
      int place = ZIGZAG[i];
      int kind = ((place >> 2) & 1) + (place & 1) == 1 ? 2 : place & 1;
      factors[i] = FACTORS[qp % 6][kind];
      scales[i] = SCALES[qp % 6][kind] << (qp / 6);
      long limit = ((1L << shift) - rounding - 1) / factors[i];
      limits[place & 3] += (HALF + limit) << (16 * (place >> 2));
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
   * @param words all blocks after {@link Transform#forward}
   * @param levels gets 16 levels, in zigzag order, if any is not 0
   * @param coefficients gets what decoders make of them, row by row, if any is not 0
   * @return how many levels are not 0
   */
  int block(long[] words, int block, int[] levels, int[] coefficients) {
    int word = Transform.WORDS * block;
    if (nothing(words, word)) {
      return 0;
    }
    for (int x = 0; x < 4; x++) {
      long biased = words[word + x] + HALVES;
      int to = 16 * block + x;
      coefficients[to] = (int) (biased & 0xFFFF) - HALF;
      coefficients[to + 4] = (int) ((biased >>> 16) & 0xFFFF) - HALF;
      coefficients[to + 8] = (int) ((biased >>> 32) & 0xFFFF) - HALF;
      coefficients[to + 12] = (int) (biased >>> 48) - HALF;
    }
    int count = 0;
    for (int i = 0; i < 16; i++) {
      int place = 16 * block + ZIGZAG[i];
      int coefficient = coefficients[place];
      int sign = coefficient >> 31;
      int level = (((coefficient ^ sign) - sign) * factors[i] + rounding) >> shift;
      count += -level >>> 31;
      level = (level ^ sign) - sign;
      levels[16 * block + i] = level;
      coefficients[place] = level * scales[i];
    }
    return count;
  }

  /** Whether all coefficients are too small for a level. */
  private boolean nothing(long[] words, int word) {
    long within = -1;
    for (int x = 0; x < 4; x++) {
      within &= (limits[x] + words[word + x]) & (limits[x] - words[word + x]);
    }
    return (within & HALVES) == HALVES;
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
