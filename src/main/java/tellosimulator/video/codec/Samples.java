package tellosimulator.video.codec;

/**
 * The pixels of one macroblock in rows of 16: sixteen rows of luma, then eight rows of which the
 * left half is blue and the right half red. So all 24 blocks of 4 by 4 pixels are reached alike:
 * four in a row, the lower two rows colour.
 */
final class Samples {

  /** Bytes from one row to the next. */
  static final int STRIDE = 16;

  /** Blocks of 4 by 4 pixels. */
  static final int BLOCKS = 24;

  /** The first block of colour. */
  static final int COLOUR = 16;

  /** Where blue begins. */
  static final int BLUE = 256;

  /** Where red begins. */
  static final int RED = BLUE + 8;

  /** Bytes of both colours. */
  static final int COLOURS = 128;

  final byte[] bytes = new byte[BLUE + COLOURS];

  /** Differences of half a row each. The machine does four at once in a loop as simple as this. */
  private final long[] rows = new long[bytes.length / 8];

  /**
   * Where a block of 4 by 4 pixels begins.
   *
   * @param block from 0, four in a row
   */
  static int at(int block) {
    return (block >> 2) * 4 * STRIDE + (block & 3) * 4;
  }

  /** The number of a block of luma, column by column. */
  static int turned(int block) {
    return (block & 3) * 4 + (block >> 2);
  }

  /** Takes over the pixels of a macroblock. */
  void load(Frame frame, int column, int row) {
    int from = frame.luma.at(16 * column, 16 * row);
    for (int y = 0; y < 16; y++) {
      Words.put(bytes, STRIDE * y, Words.get(frame.luma.bytes, from));
      Words.put(bytes, STRIDE * y + 8, Words.get(frame.luma.bytes, from + 8));
      from += frame.luma.stride;
    }
    from = frame.blue.at(8 * column, 8 * row);
    for (int y = 0; y < 8; y++) {
      Words.put(bytes, BLUE + STRIDE * y, Words.get(frame.blue.bytes, from));
      Words.put(bytes, RED + STRIDE * y, Words.get(frame.red.bytes, from));
      from += frame.blue.stride;
    }
  }

  /** Puts the pixels into a frame. */
  void store(Frame frame, int column, int row) {
    int to = frame.luma.at(16 * column, 16 * row);
    for (int y = 0; y < 16; y++) {
      Words.put(frame.luma.bytes, to, Words.get(bytes, STRIDE * y));
      Words.put(frame.luma.bytes, to + 8, Words.get(bytes, STRIDE * y + 8));
      to += frame.luma.stride;
    }
    to = frame.blue.at(8 * column, 8 * row);
    for (int y = 0; y < 8; y++) {
      Words.put(frame.blue.bytes, to, Words.get(bytes, BLUE + STRIDE * y));
      Words.put(frame.red.bytes, to, Words.get(bytes, RED + STRIDE * y));
      to += frame.blue.stride;
    }
  }

  /** The sum of absolute differences of luma. */
  int lumaDifference(Samples other) {
    long sum = 0;
    for (int i = 0; i < BLUE; i += 8) {
      sum += Words.differences(Words.get(bytes, i), Words.get(other.bytes, i));
    }
    return Words.sum(sum);
  }

  /** The same of some rows. */
  int lumaDifference(Samples other, int first, int step) {
    long sum = 0;
    for (int i = first * STRIDE; i < BLUE; i += step * STRIDE) {
      sum += Words.differences(Words.get(bytes, i), Words.get(other.bytes, i));
      sum += Words.differences(Words.get(bytes, i + 8), Words.get(other.bytes, i + 8));
    }
    return Words.sum(sum);
  }

  /** The sum of absolute differences of both colours. */
  int colourDifference(Samples other) {
    long sum = 0;
    for (int i = BLUE; i < bytes.length; i += 8) {
      sum += Words.differences(Words.get(bytes, i), Words.get(other.bytes, i));
    }
    return Words.sum(sum);
  }

  /**
   * The sums of absolute differences of all 24 blocks.
   *
   * @param sums gets them
   */
  void differences(Samples other, int[] sums) {
    for (int i = 0; i < rows.length; i++) {
      rows[i] = Words.differences(Words.get(bytes, 8 * i), Words.get(other.bytes, 8 * i));
    }
    for (int block = 0; block < BLOCKS; block += 2) {
      int row = at(block) / 8;
      long lanes = rows[row] + rows[row + 2] + rows[row + 4] + rows[row + 6];
      long pairs = lanes + (lanes >>> 16);
      sums[block] = (int) (pairs & 0xFFFF);
      sums[block + 1] = (int) ((pairs >>> 32) & 0xFFFF);
    }
  }
}
