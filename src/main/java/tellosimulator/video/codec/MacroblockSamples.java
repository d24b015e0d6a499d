package tellosimulator.video.codec;

/**
 * The 4:2:0 samples of one macroblock with a stride of 16: sixteen rows of luma, then eight rows
 * with Cb in the left half and Cr in the right. So all 24 blocks of 4x4 samples have the same
 * layout: four in a row, the last two rows of blocks chroma.
 */
final class MacroblockSamples {

  /** From one row to the next [bytes]. */
  static final int STRIDE = 16;

  /** The number of 4x4 blocks. */
  static final int BLOCKS = 24;

  /** The first chroma block. */
  static final int CHROMA = 16;

  /** Offset of Cb. */
  static final int CB = 256;

  /** Offset of Cr. */
  static final int CR = CB + 8;

  /** Size of Cb and Cr together. */
  static final int CHROMA_BYTES = 128;

  final byte[] bytes = new byte[CB + CHROMA_BYTES];

  /**
   * SADs of eight samples each, in four lanes. HotSpot vectorises the loop that fills them, as it
   * is so simple.
   */
  private final long[] rows = new long[bytes.length / 8];

  /**
   * The offset of a 4x4 block.
   *
   * @param block its number in raster order, four in a row
   */
  static int offset(int block) {
    return (block >> 2) * 4 * STRIDE + (block & 3) * 4;
  }

  /** The column-major number of a luma block. */
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

  /** The SAD of luma. */
  int lumaSad(MacroblockSamples other) {
    long sum = 0;
    for (int i = 0; i < CB; i += 8) {
      sum += Swar.absoluteDifferences(Swar.load(bytes, i), Swar.load(other.bytes, i));
    }
    return Swar.horizontalSum(sum);
  }

  /** The SAD of each {@code step}-th row of luma from {@code first} on. */
  int lumaSad(MacroblockSamples other, int first, int step) {
    long sum = 0;
    for (int i = first * STRIDE; i < CB; i += step * STRIDE) {
      sum += Swar.absoluteDifferences(Swar.load(bytes, i), Swar.load(other.bytes, i));
      sum += Swar.absoluteDifferences(Swar.load(bytes, i + 8), Swar.load(other.bytes, i + 8));
    }
    return Swar.horizontalSum(sum);
  }

  /** The SAD of Cb and Cr. */
  int chromaSad(MacroblockSamples other) {
    long sum = 0;
    for (int i = CB; i < bytes.length; i += 8) {
      sum += Swar.absoluteDifferences(Swar.load(bytes, i), Swar.load(other.bytes, i));
    }
    return Swar.horizontalSum(sum);
  }

  /**
   * The SADs of all 24 blocks.
   *
   * @param sums receives them
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
