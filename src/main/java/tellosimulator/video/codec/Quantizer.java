package tellosimulator.video.codec;

import org.jcodec.codecs.h264.H264Const;

/**
 * Quantises transform coefficients and rescales levels at one QP. The QP is from 0 to 51, and an
 * increase by six doubles the step. The tables are immutable. The coefficients of a block are
 * stored column by column.
 */
final class Quantizer {

  /**
   * The normAdjust4x4 values for even positions, for odd positions, and for all others. Documented:
   * H.264, 8.5.9.
   */
  private static final int[][] LEVEL_SCALE = {
    {10, 16, 13}, {11, 18, 14}, {13, 20, 16}, {14, 23, 18}, {16, 25, 20}, {18, 29, 23}
  };

  /**
   * Multiplication factors of the quantiser. They are the inverses of {@link #LEVEL_SCALE}, times
   * 2^15 and the norm of the transform, as in JM and x264.
   */
  private static final int[][] QUANT_MF = {
    {13107, 5243, 8066},
    {11916, 4660, 7490},
    {10082, 4194, 6554},
    {9362, 3647, 5825},
    {8192, 3355, 5243},
    {7282, 2893, 4559}
  };

  /** The zigzag scan (H.264, 8.5.6) for coefficients stored column by column. */
  private static final int[] ZIGZAG = {0, 4, 1, 2, 5, 8, 12, 9, 6, 3, 7, 10, 13, 14, 11, 15};

  /** The mask bit of each coefficient, given by its position in the zigzag scan. */
  private static final int[] ZIGZAG_BIT = zigzagBits();

  private static final int[] CHROMA_QP = H264Const.QP_SCALE_CR.clone();

  /** Half the range of a 16-bit lane. */
  private static final int LANE_BIAS = 0x8000;

  private static final long LANE_BIASES = Swar.broadcast16(LANE_BIAS);

  /**
   * The factor of each coefficient. The factors are repeated for each block, so that HotSpot
   * vectorises loops over several blocks.
   */
  private final int[] quantMf = new int[16 * MacroblockSamples.BLOCKS];

  private final int[] levelScale = new int[16 * MacroblockSamples.BLOCKS];

  /**
   * The largest coefficients that are quantised to zero, plus {@link #LANE_BIAS}. Each word holds
   * the four values of one column.
   */
  private final long[] zeroThresholds = new long[4];

  private final int qBits;
  private final int rounding;

  /**
   * Qstep, on the scale of sample differences; on this scale, a difference of 1 throughout a block
   * gives a DC coefficient of 4.
   */
  final double stepSize;

  /**
   * Creates the tables for a QP.
   *
   * @param qp from 0 to 51
   * @param roundingSixths rounding offset in sixths of a step
   */
  Quantizer(int qp, int roundingSixths) {
    qBits = 15 + qp / 6;
    rounding = (1 << qBits) * roundingSixths / 6;
    stepSize = 0.625 * StrictMath.pow(2, qp / 6.0);
    for (int i = 0; i < 16; i++) {
      int position = ZIGZAG[i];
      int positionClass = ((position >> 2) & 1) + (position & 1) == 1 ? 2 : position & 1;
      for (int at = position; at < quantMf.length; at += 16) {
        quantMf[at] = QUANT_MF[qp % 6][positionClass];
        levelScale[at] = LEVEL_SCALE[qp % 6][positionClass] << (qp / 6);
      }
      long zeroThreshold = ((1L << qBits) - rounding - 1) / quantMf[position];
      zeroThresholds[position >> 2] += (LANE_BIAS + zeroThreshold) << (16 * (position & 3));
    }
  }

  /** Returns the index of the coefficient at a position of the zigzag scan. */
  static int zigzag(int index) {
    return ZIGZAG[index];
  }

  /** Returns QPc (H.264, table 8-15, with chroma_qp_index_offset 0). */
  static int chromaQp(int qp) {
    return CHROMA_QP[qp];
  }

  /**
   * Quantises a block and rescales its levels.
   *
   * @param words all blocks after {@link Transform#forward}
   * @param coefficients receives the rescaled levels, 16 for each block, if any level is nonzero
   */
  void quantizeBlock(long[] words, int block, Residual residual, int[] coefficients) {
    if (allZero(words, Transform.WORDS_PER_BLOCK * block)) {
      residual.nonZeroMasks[block] = 0;
    } else {
      quantizeBlocks(words, block, block + 1, residual, coefficients);
    }
  }

  /**
   * Quantises and rescales several blocks without testing whether any level is nonzero.
   *
   * @param to the number of the last block plus 1
   */
  void quantizeBlocks(long[] words, int from, int to, Residual residual, int[] coefficients) {
    unpack(words, Transform.WORDS_PER_BLOCK * from, Transform.WORDS_PER_BLOCK * to, coefficients);
    quantize(coefficients, 16 * from, 16 * to, residual.levels);
    for (int block = from; block < to; block++) {
      residual.nonZeroMasks[block] = nonZeroMask(residual.levels, 16 * block);
    }
    rescale(residual.levels, 16 * from, 16 * to, coefficients);
  }

  private static void unpack(long[] words, int from, int to, int[] coefficients) {
    for (int i = from; i < to; i++) {
      long biased = words[i] + LANE_BIASES;
      coefficients[4 * i] = (int) (biased & 0xFFFF) - LANE_BIAS;
      coefficients[4 * i + 1] = (int) ((biased >>> 16) & 0xFFFF) - LANE_BIAS;
      coefficients[4 * i + 2] = (int) ((biased >>> 32) & 0xFFFF) - LANE_BIAS;
      coefficients[4 * i + 3] = (int) (biased >>> 48) - LANE_BIAS;
    }
  }

  private void quantize(int[] coefficients, int from, int to, int[] levels) {
    int[] multipliers = quantMf;
    int add = rounding;
    int shift = qBits;
    for (int i = from; i < to; i++) {
      int coefficient = coefficients[i];
      int sign = coefficient >> 31;
      int level = (((coefficient ^ sign) - sign) * multipliers[i] + add) >> shift;
      levels[i] = (level ^ sign) - sign;
    }
  }

  private void rescale(int[] levels, int from, int to, int[] coefficients) {
    int[] multipliers = levelScale;
    for (int i = from; i < to; i++) {
      coefficients[i] = levels[i] * multipliers[i];
    }
  }

  private static int nonZeroMask(int[] levels, int first) {
    int nonZeroMask = 0;
    for (int i = 0; i < 16; i++) {
      int level = levels[first + i];
      nonZeroMask |= ((level | -level) >> 31) & ZIGZAG_BIT[i];
    }
    return nonZeroMask;
  }

  private static int[] zigzagBits() {
    int[] zigzagBits = new int[16];
    for (int i = 0; i < 16; i++) {
      zigzagBits[ZIGZAG[i]] = 1 << i;
    }
    return zigzagBits;
  }

  /** Returns whether all coefficients of a block are quantised to zero. */
  private boolean allZero(long[] words, int word) {
    long zero = -1;
    for (int x = 0; x < 4; x++) {
      zero &= (zeroThresholds[x] + words[word + x]) & (zeroThresholds[x] - words[word + x]);
    }
    return (zero & LANE_BIASES) == LANE_BIASES;
  }

  /**
   * Quantises a DC block in place, after its Hadamard transform.
   *
   * @param dc the coefficients, in scan order
   * @return the number of nonzero levels
   */
  int quantizeDc(int[] dc, int offset, int length) {
    int count = 0;
    for (int i = offset; i < offset + length; i++) {
      int sign = dc[i] >> 31;
      int level = (((dc[i] ^ sign) - sign) * quantMf[0] + 2 * rounding) >> (qBits + 1);
      if (level != 0) {
        count++;
      }
      dc[i] = (level ^ sign) - sign;
    }
    return count;
  }

  /** Rescales an Intra 16x16 luma DC level after its inverse Hadamard transform (H.264, 8.5.10). */
  int dequantizeLumaDc(int transformed) {
    return (transformed * levelScale[0] + 2) >> 2;
  }

  /** Rescales a chroma DC level after its inverse Hadamard transform (H.264, 8.5.11.2). */
  int dequantizeChromaDc(int transformed) {
    return (transformed * levelScale[0]) >> 1;
  }
}
