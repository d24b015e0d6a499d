package tellosimulator.video.codec;

import org.jcodec.codecs.h264.H264Const;

/**
 * How finely coefficients are told at one quality (QP, 0 to 51: six more are half as fine).
 * Immutable tables; a block's coefficients are a column after another.
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

  /** Where levels are that are sent one after another: column by column. */
  private static final int[] ZIGZAG = {0, 4, 1, 2, 5, 8, 12, 9, 6, 3, 7, 10, 13, 14, 11, 15};

  /** The bit of each level in a mask, by place. */
  private static final int[] MARKS = marks();

  private static final int[] COLOUR_QP = H264Const.QP_SCALE_CR.clone();

  /** Half of a lane. */
  private static final int HALF = 0x8000;

  private static final long HALVES = Words.lanes(HALF);

  /**
   * By place, for each block again: the machine does eight at once in loops over several blocks.
   */
  private final int[] factors = new int[16 * Samples.BLOCKS];

  private final int[] scales = new int[16 * Samples.BLOCKS];

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
      for (int at = place; at < factors.length; at += 16) {
        factors[at] = FACTORS[qp % 6][kind];
        scales[at] = SCALES[qp % 6][kind] << (qp / 6);
      }
      long limit = ((1L << shift) - rounding - 1) / factors[place];
      limits[place >> 2] += (HALF + limit) << (16 * (place & 3));
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
   * @param coefficients gets 16 a block: what decoders make of its levels, if any is not 0
   */
  void block(long[] words, int block, Residual residual, int[] coefficients) {
    if (nothing(words, Transform.WORDS * block)) {
      residual.masks[block] = 0;
    } else {
      blocks(words, block, block + 1, residual, coefficients);
    }
  }

  /**
   * The same for several blocks at once, whether anything is in them or not.
   *
   * @param to one beyond the last
   */
  void blocks(long[] words, int from, int to, Residual residual, int[] coefficients) {
    unpack(words, Transform.WORDS * from, Transform.WORDS * to, coefficients);
    quantize(coefficients, 16 * from, 16 * to, residual.levels);
    for (int block = from; block < to; block++) {
      residual.masks[block] = mask(residual.levels, 16 * block);
    }
    scale(residual.levels, 16 * from, 16 * to, coefficients);
  }

  private static void unpack(long[] words, int from, int to, int[] coefficients) {
    for (int i = from; i < to; i++) {
      long biased = words[i] + HALVES;
      coefficients[4 * i] = (int) (biased & 0xFFFF) - HALF;
      coefficients[4 * i + 1] = (int) ((biased >>> 16) & 0xFFFF) - HALF;
      coefficients[4 * i + 2] = (int) ((biased >>> 32) & 0xFFFF) - HALF;
      coefficients[4 * i + 3] = (int) (biased >>> 48) - HALF;
    }
  }

  private void quantize(int[] coefficients, int from, int to, int[] levels) {
    int[] by = factors;
    int add = rounding;
    int right = shift;
    for (int i = from; i < to; i++) {
      int coefficient = coefficients[i];
      int sign = coefficient >> 31;
      int level = (((coefficient ^ sign) - sign) * by[i] + add) >> right;
      levels[i] = (level ^ sign) - sign;
    }
  }

  private void scale(int[] levels, int from, int to, int[] coefficients) {
    int[] by = scales;
    for (int i = from; i < to; i++) {
      coefficients[i] = levels[i] * by[i];
    }
  }

  private static int mask(int[] levels, int first) {
    int mask = 0;
    for (int i = 0; i < 16; i++) {
      int level = levels[first + i];
      mask |= ((level | -level) >> 31) & MARKS[i];
    }
    return mask;
  }

  private static int[] marks() {
    int[] marks = new int[16];
    for (int i = 0; i < 16; i++) {
      marks[ZIGZAG[i]] = 1 << i;
    }
    return marks;
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
