package tellosimulator.video.codec;

/**
 * The 4:2:0 samples of one macroblock with a stride of 16. Sixteen rows of luma are followed by
 * eight rows that contain Cb in the left half and Cr in the right half. All 24 blocks of 4x4
 * samples therefore have the same layout, with four blocks in a row; the last two rows of blocks
 * are chroma.
 */
final class MacroblockSamples {

  /** The distance between the beginnings of two rows [bytes]. */
  static final int STRIDE = 16;

  /** The number of 4x4 blocks. */
  static final int BLOCKS = 24;

  /** The number of the first chroma block. */
  static final int CHROMA = 16;

  /** The offset of Cb. */
  static final int CB = 256;

  /** The offset of Cr. */
  static final int CR = CB + 8;

  /** The size of Cb and Cr together [bytes]. */
  static final int CHROMA_BYTES = 128;

  final byte[] bytes = new byte[CB + CHROMA_BYTES];

  /**
   * The SADs of groups of eight samples. Each word has four lanes, one for each pair of samples.
   * The loop that computes them is simple enough for HotSpot to vectorise.
   */
  private final long[] rows = new long[bytes.length / 8];

  /**
   * Returns the offset of a 4x4 block.
   *
   * @param block the block's number in raster order, four in a row
   */
  static int offset(int block) {
    return (block >> 2) * 4 * STRIDE + (block & 3) * 4;
  }

  /** Converts the number of a luma block from raster order to column-major order. */
  static int transposed(int block) {
    return (block & 3) * 4 + (block >> 2);
  }

  /** Loads a macroblock of a frame. */
  void load(Frame frame, int column, int row) {
    int from = frame.luma.offset(16 * column, 16 * row);
    for (int y = 0; y < 16; y++) {
      Swar.store(bytes, STRIDE * y, Swar.load(frame.luma.bytes, from));
      Swar.store(bytes, STRIDE * y + 8, Swar.load(frame.luma.bytes, from + 8));
      from += frame.luma.stride;
    }
    from = frame.cb.offset(8 * column, 8 * row);
    for (int y = 0; y < 8; y++) {
      Swar.store(bytes, CB + STRIDE * y, Swar.load(frame.cb.bytes, from));
      Swar.store(bytes, CR + STRIDE * y, Swar.load(frame.cr.bytes, from));
      from += frame.cb.stride;
    }
  }

  /** Stores the samples in a frame. */
  void store(Frame frame, int column, int row) {
    int to = frame.luma.offset(16 * column, 16 * row);
    for (int y = 0; y < 16; y++) {
      Swar.store(frame.luma.bytes, to, Swar.load(bytes, STRIDE * y));
      Swar.store(frame.luma.bytes, to + 8, Swar.load(bytes, STRIDE * y + 8));
      to += frame.luma.stride;
    }
    to = frame.cb.offset(8 * column, 8 * row);
    for (int y = 0; y < 8; y++) {
      Swar.store(frame.cb.bytes, to, Swar.load(bytes, CB + STRIDE * y));
      Swar.store(frame.cr.bytes, to, Swar.load(bytes, CR + STRIDE * y));
      to += frame.cb.stride;
    }
  }

  /** Returns the SAD of luma. */
  int lumaSad(MacroblockSamples other) {
    long sum = 0;
    for (int i = 0; i < CB; i += 8) {
      sum += Swar.absoluteDifferences(Swar.load(bytes, i), Swar.load(other.bytes, i));
    }
    return Swar.horizontalSum(sum);
  }

  /** Returns the SAD of every {@code step}-th row of luma, starting with {@code first}. */
  int lumaSad(MacroblockSamples other, int first, int step) {
    long sum = 0;
    for (int i = first * STRIDE; i < CB; i += step * STRIDE) {
      sum += Swar.absoluteDifferences(Swar.load(bytes, i), Swar.load(other.bytes, i));
      sum += Swar.absoluteDifferences(Swar.load(bytes, i + 8), Swar.load(other.bytes, i + 8));
    }
    return Swar.horizontalSum(sum);
  }

  /** Returns the SAD of Cb and Cr. */
  int chromaSad(MacroblockSamples other) {
    long sum = 0;
    for (int i = CB; i < bytes.length; i += 8) {
      sum += Swar.absoluteDifferences(Swar.load(bytes, i), Swar.load(other.bytes, i));
    }
    return Swar.horizontalSum(sum);
  }

  /**
   * Computes the SADs of all 24 blocks.
   *
   * @param sums receives the SADs
   */
  void blockSads(MacroblockSamples other, int[] sums) {
    for (int i = 0; i < rows.length; i++) {
      rows[i] = Swar.absoluteDifferences(Swar.load(bytes, 8 * i), Swar.load(other.bytes, 8 * i));
    }
    for (int block = 0; block < BLOCKS; block += 2) {
      int row = offset(block) / 8;
      long lanes = rows[row] + rows[row + 2] + rows[row + 4] + rows[row + 6];
      long pairs = lanes + (lanes >>> 16);
      sums[block] = (int) (pairs & 0xFFFF);
      sums[block + 1] = (int) ((pairs >>> 32) & 0xFFFF);
    }
  }
}
