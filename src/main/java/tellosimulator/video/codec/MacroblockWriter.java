package tellosimulator.video.codec;

import org.jcodec.codecs.h264.H264Const;

/**
 * Writes the syntax of a slice: the header, and then the macroblocks one after another (slice_data
 * and macroblock_layer; H.264, 7.3.3 to 7.3.5).
 */
final class MacroblockWriter {

  /**
   * The slice_type of a slice in a picture that has only P slices. Documented: H.264, table 7-6.
   */
  private static final int P_SLICE = 5;

  private static final int I_SLICE = 7;

  /**
   * The offset that is added to the mb_type of I macroblocks in P slices. Documented: H.264, table
   * 7-13.
   */
  private static final int I_MB_TYPE_OFFSET_IN_P = 5;

  /** Space that is reserved for a macroblock [bytes]. Decided: more than a macroblock can take. */
  private static final int MAX_MACROBLOCK_BYTES = 4096;

  /** The codeNum of each coded_block_pattern in Inter macroblocks (H.264, table 9-4). */
  private static final int[] INTER_CBP_CODES =
      H264Const.CODED_BLOCK_PATTERN_INTER_COLOR_INV.clone();

  private final BitWriter bits = new BitWriter();
  private final CavlcWriter cavlc = new CavlcWriter(bits);
  private final TotalCoefficients lumaCounts;
  private final TotalCoefficients cbCounts;
  private final TotalCoefficients crCounts;
  private boolean idr;
  private int mbSkipRun;
  private int qp;

  MacroblockWriter(int widthInMbs, int heightInMbs) {
    lumaCounts = new TotalCoefficients(4 * widthInMbs, 4 * heightInMbs);
    cbCounts = new TotalCoefficients(2 * widthInMbs, 2 * heightInMbs);
    crCounts = new TotalCoefficients(2 * widthInMbs, 2 * heightInMbs);
  }

  /**
   * Begins a slice and writes its header.
   *
   * @param idrPicId used only for IDR slices
   */
  void beginSlice(boolean newIdr, int frameNum, int idrPicId, int sliceQp) {
    idr = newIdr;
    mbSkipRun = 0;
    qp = sliceQp;
    bits.clear();
    bits.putUe(0);
    bits.putUe(idr ? I_SLICE : P_SLICE);
    bits.putUe(0);
    bits.put(frameNum, ParameterSets.FRAME_NUM_BITS);
    if (idr) {
      bits.putUe(idrPicId);
      bits.put(0, 2); // no_output_of_prior_pics_flag, long_term_reference_flag
    } else {
      bits.put(0, 3); // no override of num_ref_idx, no reordering, sliding window marking
    }
    bits.putSe(sliceQp - ParameterSets.PIC_INIT_QP);
    bits.putUe(1); // disable_deblocking_filter_idc
  }

  /** Ends the slice and returns its RBSP. */
  BitWriter finishSlice() {
    bits.reserve(MAX_MACROBLOCK_BYTES);
    if (mbSkipRun > 0) {
      bits.putUe(mbSkipRun);
    }
    bits.putTrailingBits();
    return bits;
  }

  /** The current size of the slice [bit]. */
  int bitCount() {
    return bits.bitCount();
  }

  /** Codes a P_Skip macroblock. */
  void skip(Macroblock macroblock) {
    mbSkipRun++;
    macroblock.residual.clear();
    storeTotalCoeffs(macroblock);
  }

  /** Writes a P_L0_16x16 macroblock. */
  void inter16x16(Macroblock macroblock) {
    Residual residual = macroblock.residual;
    mbType(0);
    bits.putSe(macroblock.mvdX);
    bits.putSe(macroblock.mvdY);
    bits.putUe(INTER_CBP_CODES[residual.codedBlockPattern()]);
    storeTotalCoeffs(macroblock);
    if (residual.codedBlockPattern() != 0) {
      mbQpDelta(macroblock.tables.qp());
      luma(macroblock, 0);
      chroma(macroblock);
    }
  }

  /** Writes an Intra 16x16 macroblock. */
  void intra16x16(Macroblock macroblock) {
    Residual residual = macroblock.residual;
    int mbType = 1 + macroblock.intra16x16PredMode + 4 * residual.cbpChroma;
    mbType((idr ? 0 : I_MB_TYPE_OFFSET_IN_P) + mbType + (residual.cbpLuma == 0 ? 0 : 12));
    bits.putUe(macroblock.intraChromaPredMode);
    mbQpDelta(macroblock.tables.qp());
    storeTotalCoeffs(macroblock);
    int nC = lumaCounts.nC(4 * macroblock.mbX, 4 * macroblock.mbY);
    cavlc.writeDc(residual.dcLevels, 0, 16, nC);
    luma(macroblock, 1);
    chroma(macroblock);
  }

  /** Writes mb_skip_run (only in P slices) and mb_type. */
  private void mbType(int mbType) {
    bits.reserve(MAX_MACROBLOCK_BYTES);
    if (!idr) {
      bits.putUe(mbSkipRun);
      mbSkipRun = 0;
    }
    bits.putUe(mbType);
  }

  /** Writes mb_qp_delta. */
  private void mbQpDelta(int newQp) {
    bits.putSe(newQp - qp);
    qp = newQp;
  }

  private void storeTotalCoeffs(Macroblock macroblock) {
    int[] masks = macroblock.residual.nonZeroMasks;
    for (int block = 0; block < MacroblockSamples.CHROMA; block++) {
      lumaCounts.set(
          4 * macroblock.mbX + (block & 3),
          4 * macroblock.mbY + (block >> 2),
          Integer.bitCount(masks[block]));
    }
    for (int i = 0; i < 4; i++) {
      int column = 2 * macroblock.mbX + (i & 1);
      int row = 2 * macroblock.mbY + (i >> 1);
      int block = MacroblockSamples.CHROMA + (i >> 1) * 4 + (i & 1);
      cbCounts.set(column, row, Integer.bitCount(masks[block]));
      crCounts.set(column, row, Integer.bitCount(masks[block + 2]));
    }
  }

  /** Writes the luma blocks, grouped by 8x8 block. */
  private void luma(Macroblock macroblock, int first) {
    Residual residual = macroblock.residual;
    for (int i = 0; i < 16; i++) {
      if (((residual.cbpLuma >> (i >> 2)) & 1) != 0) {
        int x = ((i >> 2) & 1) * 2 + (i & 1);
        int y = (i >> 3) * 2 + ((i >> 1) & 1);
        int block = 4 * y + x;
        int nC = lumaCounts.nC(4 * macroblock.mbX + x, 4 * macroblock.mbY + y);
        block(residual, block, first, nC);
      }
    }
  }

  private void chroma(Macroblock macroblock) {
    Residual residual = macroblock.residual;
    if (residual.cbpChroma > 0) {
      cavlc.writeDc(residual.dcLevels, Residual.CB_DC, 4, CavlcWriter.CHROMA_DC_NC);
      cavlc.writeDc(residual.dcLevels, Residual.CR_DC, 4, CavlcWriter.CHROMA_DC_NC);
    }
    if (residual.cbpChroma == 2) {
      chromaAc(macroblock, cbCounts, MacroblockSamples.CHROMA);
      chromaAc(macroblock, crCounts, MacroblockSamples.CHROMA + 2);
    }
  }

  private void chromaAc(Macroblock macroblock, TotalCoefficients counts, int first) {
    for (int i = 0; i < 4; i++) {
      int x = 2 * macroblock.mbX + (i & 1);
      int y = 2 * macroblock.mbY + (i >> 1);
      block(macroblock.residual, first + (i >> 1) * 4 + (i & 1), 1, counts.nC(x, y));
    }
  }

  private void block(Residual residual, int block, int first, int nC) {
    int mask = residual.nonZeroMasks[block];
    if (mask == 0) {
      cavlc.writeEmptyBlock(nC);
    } else {
      cavlc.writeBlock(residual.levels, 16 * block, mask, 16 - first, nC);
    }
  }

  /** The total_coeff of each 4x4 block in one plane. */
  private static final class TotalCoefficients {

    private final byte[] counts;
    private final int columns;

    TotalCoefficients(int columns, int rows) {
      this.columns = columns;
      counts = new byte[columns * rows];
    }

    void set(int column, int row, int totalCoeff) {
      counts[row * columns + column] = (byte) totalCoeff;
    }

    /**
     * Returns nC (H.264, 9.2.1), the mean of nA (left) and nB (above), as far as they are
     * available.
     */
    int nC(int column, int row) {
      int at = row * columns + column;
      if (column == 0) {
        return row == 0 ? 0 : counts[at - columns];
      }
      if (row == 0) {
        return counts[at - 1];
      }
      return (counts[at - 1] + counts[at - columns] + 1) >> 1;
    }
  }
}
