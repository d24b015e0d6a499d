package tellosimulator.video.codec;

import java.util.Arrays;

/**
 * The levels that a macroblock sends: what its prediction lacks. Blocks are counted as in {@link
 * Samples}; each block's levels are a column after another.
 */
final class Residual {

  /** In {@link #first}: where those of blue begin. */
  static final int BLUE = 16;

  /** In {@link #first}: where those of red begin. */
  static final int RED = 20;

  /** 16 levels a block. */
  final int[] levels = new int[Samples.BLOCKS * 16];

  /** Which of a block's levels are not 0: a bit each, the lowest first in zigzag order. */
  final int[] masks = new int[Samples.BLOCKS];

  /** First levels that are sent apart: of luma (intra 16 by 16 only), of blue, of red. */
  final int[] first = new int[16 + 4 + 4];

  /** A bit for each quarter of luma that has levels; upper left, upper right, lower left, ... */
  int lumaPattern;

  /** 0 where colour has no levels, 1 where it has first levels only, 2 otherwise. */
  int colourPattern;

  void clear() {
    Arrays.fill(masks, 0);
    lumaPattern = 0;
    colourPattern = 0;
  }

  /** Both patterns in one number. */
  int pattern() {
    return lumaPattern | (colourPattern << 4);
  }
}
