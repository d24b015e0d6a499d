package tellosimulator.video.codec;

import java.util.stream.IntStream;
import org.jcodec.codecs.h264.H264Const;
import org.jcodec.common.io.VLC;

/**
 * Writes residual blocks in CAVLC (H.264, 9.2) with JCodec's VLC tables. JCodec's own writer is not
 * used, because it allocates arrays for each block.
 */
final class CavlcWriter {

  /** The smallest nC of the last coeff_token table. All higher values of nC share this table. */
  private static final int LAST_TABLE_NC = 8;

  /**
   * The index of the coeff_token table for chroma DC, for which the standard uses nC = -1. Real
   * values of nC are at most 16.
   */
  static final int CHROMA_DC_NC = 17;

  /** The coeff_token tables, by nC. */
  private static final int[][] COEFF_TOKEN = coeffTokens();

  /** The total_zeros tables of 4x4 blocks, by total_coeff - 1. */
  private static final int[][] TOTAL_ZEROS = vlcTables(H264Const.totalZeros16);

  /** The total_zeros tables of chroma DC 2x2 blocks, by total_coeff - 1. */
  private static final int[][] TOTAL_ZEROS_CHROMA_DC = vlcTables(H264Const.totalZeros4);

  /** The run_before tables, by min(zerosLeft, 7) - 1. */
  private static final int[][] RUN_BEFORE = vlcTables(H264Const.run);

  private static final int LENGTH_SHIFT = 16;

  private static final int[] ZIGZAG = IntStream.range(0, 16).map(Quantizer::zigzag).toArray();
  private static final int[] SCAN_ORDER = IntStream.range(0, 16).toArray();

  private final BitWriter bits;
  private final int[] nonZero = new int[16];
  private final int[] positions = new int[16];

  CavlcWriter(BitWriter bits) {
    this.bits = bits;
  }

  private static int[][] coeffTokens() {
    int[][] all = new int[CHROMA_DC_NC + 1][];
    for (int nC = 0; nC < CHROMA_DC_NC; nC++) {
      all[nC] = vlcTables(H264Const.CoeffToken[Math.min(nC, LAST_TABLE_NC)]);
    }
    all[CHROMA_DC_NC] = vlcTables(H264Const.coeffTokenChromaDCY420);
    return all;
  }

  private static int[][] vlcTables(VLC[] tables) {
    int[][] all = new int[tables.length][];
    for (int i = 0; i < tables.length; i++) {
      all[i] = vlcTables(tables[i]);
    }
    return all;
  }

  /**
   * Packs a VLC table. Each entry has the codeword in its lower half and the length in its upper
   * half.
   */
  private static int[] vlcTables(VLC table) {
    int[] codes = new int[table.getCodes().length];
    for (int i = 0; i < codes.length; i++) {
      int length = table.getCodeSizes()[i];
      codes[i] = (length << LENGTH_SHIFT) | (table.getCodes()[i] >>> (Integer.SIZE - length));
    }
    return codes;
  }

  /** Writes a block with total_coeff = 0. */
  void writeEmptyBlock(int nC) {
    put(COEFF_TOKEN[nC], 0);
  }

  /** Writes a DC block; its levels must be in scan order. */
  void writeDc(int[] levels, int offset, int length, int nC) {
    int nonZeroMask = 0;
    for (int i = 0; i < length; i++) {
      nonZeroMask |= (-Math.abs(levels[offset + i]) >>> 31) << i;
    }
    if (nonZeroMask == 0) {
      writeEmptyBlock(nC);
      return;
    }
    collect(levels, offset, nonZeroMask, SCAN_ORDER);
    writeResidual(nonZeroMask, length, nC);
  }

  /**
   * Writes a 4x4 block that has nonzero levels.
   *
   * @param levels the levels of the block, column by column from {@code offset} on
   * @param nonZeroMask a bit for each position of the zigzag scan; set if the level is nonzero
   * @param length maxNumCoeff: 16, or 15 without DC
   * @param nC the predicted number of nonzero levels
   */
  void writeBlock(int[] levels, int offset, int nonZeroMask, int length, int nC) {
    collect(levels, offset, nonZeroMask, ZIGZAG);
    writeResidual(nonZeroMask >>> (16 - length), length, nC);
  }

  /**
   * Collects the nonzero levels in reverse scan order.
   *
   * @param scan the index of the level at each scan position
   */
  private void collect(int[] levels, int offset, int nonZeroMask, int[] scan) {
    int totalCoeff = 0;
    for (int left = nonZeroMask; left != 0; totalCoeff++) {
      int position = 31 - Integer.numberOfLeadingZeros(left);
      nonZero[totalCoeff] = levels[offset + scan[position]];
      positions[totalCoeff] = position;
      left ^= 1 << position;
    }
  }

  /**
   * Writes residual_block_cavlc for the collected levels.
   *
   * @param nonZeroMask the scan positions of the levels
   * @param length maxNumCoeff
   */
  private void writeResidual(int nonZeroMask, int length, int nC) {
    int totalCoeff = Integer.bitCount(nonZeroMask);
    int trailingOnes = 0;
    int signs = 0;
    while (trailingOnes < totalCoeff && trailingOnes < 3 && Math.abs(nonZero[trailingOnes]) == 1) {
      signs = 2 * signs + (nonZero[trailingOnes] >>> 31);
      trailingOnes++;
    }
    int coeffToken = COEFF_TOKEN[nC][coeffTokenIndex(totalCoeff, trailingOnes)];
    bits.put((code(coeffToken) << trailingOnes) | signs, length(coeffToken) + trailingOnes);
    writeLevels(totalCoeff, trailingOnes);
    int totalZeros = 32 - Integer.numberOfLeadingZeros(nonZeroMask) - totalCoeff;
    if (totalCoeff < length) {
      put((length == 4 ? TOTAL_ZEROS_CHROMA_DC : TOTAL_ZEROS)[totalCoeff - 1], totalZeros);
    }
    writeRuns(totalCoeff, totalZeros);
  }

  /**
   * Returns the index of a coeff_token in JCodec's tables, which are ordered by total_coeff and
   * then by trailing ones.
   */
  private static int coeffTokenIndex(int totalCoeff, int trailingOnes) {
    return switch (totalCoeff) {
      case 0 -> 0;
      case 1 -> 1 + trailingOnes;
      case 2 -> 3 + trailingOnes;
      default -> 4 * totalCoeff - 6 + trailingOnes;
    };
  }

  private void writeLevels(int totalCoeff, int trailingOnes) {
    int suffixLength = totalCoeff > 10 && trailingOnes < 3 ? 1 : 0;
    for (int i = trailingOnes; i < totalCoeff; i++) {
      int magnitude = Math.abs(nonZero[i]);
      int levelCode = 2 * magnitude - 2 + (nonZero[i] >>> 31);
      writeLevel(i == trailingOnes && trailingOnes < 3 ? levelCode - 2 : levelCode, suffixLength);
      if (suffixLength == 0) {
        suffixLength = 1;
      }
      if (magnitude > 3 << (suffixLength - 1) && suffixLength < 6) {
        suffixLength++;
      }
    }
  }

  private void writeLevel(int levelCode, int suffixLength) {
    if (suffixLength == 0 && levelCode < 14) {
      bits.put(1, levelCode + 1);
    } else if (suffixLength == 0 && levelCode < 30) {
      bits.put(1, 15);
      bits.put(levelCode - 14, 4);
    } else if (suffixLength > 0 && levelCode < (15 << suffixLength)) {
      bits.put(1, (levelCode >> suffixLength) + 1);
      bits.put(levelCode & ((1 << suffixLength) - 1), suffixLength);
    } else {
      bits.put(1, 16);
      bits.put(levelCode - Math.max(30, 15 << suffixLength), 12);
    }
  }

  private void writeRuns(int totalCoeff, int totalZeros) {
    int zerosLeft = totalZeros;
    for (int i = 0; i < totalCoeff - 1 && zerosLeft > 0; i++) {
      int runBefore = positions[i] - positions[i + 1] - 1;
      put(RUN_BEFORE[Math.min(zerosLeft, 7) - 1], runBefore);
      zerosLeft -= runBefore;
    }
  }

  private void put(int[] table, int index) {
    bits.put(code(table[index]), length(table[index]));
  }

  private static int code(int entry) {
    return entry & ((1 << LENGTH_SHIFT) - 1);
  }

  private static int length(int entry) {
    return entry >> LENGTH_SHIFT;
  }
}
