package tellosimulator.video.codec;

import org.jcodec.codecs.h264.H264Const;

/** Writes the macroblocks of a slice one after another, and before them the slice's header. */
final class MacroblockWriter {

  /** Documented: H.264, table 7-6: a slice all of whose macroblocks are predicted from others. */
  private static final int P_SLICE = 5;

  private static final int I_SLICE = 7;

  /** Documented: H.264, table 7-13: in a P slice, types of intra macroblocks begin here. */
  private static final int INTRA_TYPES_OF_P = 5;

  /** Decided: more than a macroblock can have. */
  private static final int MOST_BYTES = 4096;

  private static final int[] INTER_PATTERNS = H264Const.CODED_BLOCK_PATTERN_INTER_COLOR_INV.clone();

  private final BitWriter bits = new BitWriter();
  private final LevelWriter levels = new LevelWriter(bits);
  private final CountGrid luma;
  private final CountGrid blue;
  private final CountGrid red;
  private boolean key;
  private int skipped;
  private int qp;

  /**
   * @param columns macroblocks from left to right
   * @param rows macroblocks from top to bottom
   */
  MacroblockWriter(int columns, int rows) {
    luma = new CountGrid(4 * columns, 4 * rows);
    blue = new CountGrid(2 * columns, 2 * rows);
    red = new CountGrid(2 * columns, 2 * rows);
  }

  /**
   * Begins a slice (H.264, 7.3.3).
   *
   * @param number of the picture since the last key picture
   * @param keyNumber of the key picture; only of one
   */
  void begin(boolean keyPicture, int number, int keyNumber, int firstQp) {
    key = keyPicture;
    skipped = 0;
    qp = firstQp;
    bits.clear();
    bits.putUnsigned(0);
    bits.putUnsigned(key ? I_SLICE : P_SLICE);
    bits.putUnsigned(0);
    bits.put(number, ParameterSets.FRAME_NUM_BITS);
    if (key) {
      bits.putUnsigned(keyNumber);
      bits.put(0, 2); // what was before may be shown; no long-term reference
    } else {
      bits.put(0, 3); // as many references as ever, in their order; none is marked
    }
    bits.putSigned(firstQp - ParameterSets.FIRST_QP);
    bits.putUnsigned(1); // edges are not filtered
  }

  /** Ends the slice. */
  BitWriter finish() {
    bits.reserve(MOST_BYTES);
    if (skipped > 0) {
      bits.putUnsigned(skipped);
    }
    bits.finish();
    return bits;
  }

  /** How many bits the slice has up to now. */
  int bits() {
    return bits.bits();
  }

  /** A macroblock as predicted, with the vector that is expected. */
  void skip(Macroblock macroblock) {
    skipped++;
    macroblock.residual.clear();
    count(macroblock);
  }

  /** A macroblock that is predicted from another picture. */
  void inter(Macroblock macroblock) {
    Residual residual = macroblock.residual;
    type(0);
    bits.putSigned(macroblock.differenceX);
    bits.putSigned(macroblock.differenceY);
    bits.putUnsigned(INTER_PATTERNS[residual.pattern()]);
    count(macroblock);
    if (residual.pattern() != 0) {
      quality(macroblock.quality.qp());
      luma(macroblock, 0);
      colour(macroblock);
    }
  }

  /** A macroblock whose luma is predicted as a whole from the same picture. */
  void intra(Macroblock macroblock) {
    Residual residual = macroblock.residual;
    int type = 1 + macroblock.lumaMode + 4 * residual.colourPattern;
    type((key ? 0 : INTRA_TYPES_OF_P) + type + (residual.lumaPattern == 0 ? 0 : 12));
    bits.putUnsigned(macroblock.colourMode);
    quality(macroblock.quality.qp());
    count(macroblock);
    int context = luma.context(4 * macroblock.column, 4 * macroblock.row);
    levels.firsts(residual.first, 0, 16, context);
    luma(macroblock, 1);
    colour(macroblock);
  }

  /** Says what kind of macroblock comes. */
  private void type(int type) {
    bits.reserve(MOST_BYTES);
    if (!key) {
      bits.putUnsigned(skipped);
      skipped = 0;
    }
    bits.putUnsigned(type);
  }

  /** Tells the quality, as a difference from the last one. */
  private void quality(int newQp) {
    bits.putSigned(newQp - qp);
    qp = newQp;
  }

  private void count(Macroblock macroblock) {
    int[] masks = macroblock.residual.masks;
    for (int block = 0; block < Samples.COLOUR; block++) {
      luma.set(
          4 * macroblock.column + (block & 3),
          4 * macroblock.row + (block >> 2),
          Integer.bitCount(masks[block]));
    }
    for (int i = 0; i < 4; i++) {
      int column = 2 * macroblock.column + (i & 1);
      int row = 2 * macroblock.row + (i >> 1);
      int block = Samples.COLOUR + (i >> 1) * 4 + (i & 1);
      blue.set(column, row, Integer.bitCount(masks[block]));
      red.set(column, row, Integer.bitCount(masks[block + 2]));
    }
  }

  /** Writes the blocks of luma, a quarter after another. */
  private void luma(Macroblock macroblock, int first) {
    Residual residual = macroblock.residual;
    for (int i = 0; i < 16; i++) {
      if (((residual.lumaPattern >> (i >> 2)) & 1) != 0) {
        int x = ((i >> 2) & 1) * 2 + (i & 1);
        int y = (i >> 3) * 2 + ((i >> 1) & 1);
        int block = 4 * y + x;
        int context = luma.context(4 * macroblock.column + x, 4 * macroblock.row + y);
        block(residual, block, first, context);
      }
    }
  }

  private void colour(Macroblock macroblock) {
    Residual residual = macroblock.residual;
    if (residual.colourPattern > 0) {
      levels.firsts(residual.first, Residual.BLUE, 4, LevelWriter.COLOUR_FIRST);
      levels.firsts(residual.first, Residual.RED, 4, LevelWriter.COLOUR_FIRST);
    }
    if (residual.colourPattern == 2) {
      colour(macroblock, blue, Samples.COLOUR);
      colour(macroblock, red, Samples.COLOUR + 2);
    }
  }

  private void colour(Macroblock macroblock, CountGrid counts, int first) {
    for (int i = 0; i < 4; i++) {
      int x = 2 * macroblock.column + (i & 1);
      int y = 2 * macroblock.row + (i >> 1);
      block(macroblock.residual, first + (i >> 1) * 4 + (i & 1), 1, counts.context(x, y));
    }
  }

  private void block(Residual residual, int block, int first, int context) {
    int mask = residual.masks[block];
    if (mask == 0) {
      levels.none(context);
    } else {
      levels.block(residual.levels, 16 * block, mask, 16 - first, context);
    }
  }
}
