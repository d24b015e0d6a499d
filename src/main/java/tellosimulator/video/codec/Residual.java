package tellosimulator.video.codec;

import java.util.Arrays;

/**
 * The quantised transform coefficient levels of a macroblock, and its coded block pattern. Blocks
 * are numbered as in {@link MacroblockSamples}. The 16 levels of a block are stored column by
 * column.
 */
final class Residual {

  /** Index of the Cb DC levels in {@link #dcLevels}. */
  static final int CB_DC = 16;

  /** Index of the Cr DC levels in {@link #dcLevels}. */
  static final int CR_DC = 20;

  /** The levels of all blocks, 16 for each block. */
  final int[] levels = new int[MacroblockSamples.BLOCKS * 16];

  /**
   * The nonzero levels of each block. Bit i stands for the level at position i of the zigzag scan.
   */
  final int[] nonZeroMasks = new int[MacroblockSamples.BLOCKS];

  /** DC levels that are coded in separate blocks: luma (Intra 16x16 only), Cb, Cr. */
  final int[] dcLevels = new int[16 + 4 + 4];

  /** CodedBlockPatternLuma: a bit for each 8x8 block that has nonzero levels, in raster order. */
  int cbpLuma;

  /** CodedBlockPatternChroma: 0 for no levels, 1 for DC levels only, 2 for DC and AC levels. */
  int cbpChroma;

  void clear() {
    Arrays.fill(nonZeroMasks, 0);
    cbpLuma = 0;
    cbpChroma = 0;
  }

  /** The syntax element coded_block_pattern. */
  int codedBlockPattern() {
    return cbpLuma | (cbpChroma << 4);
  }
}
