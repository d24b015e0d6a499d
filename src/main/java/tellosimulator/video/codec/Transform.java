package tellosimulator.video.codec;

/**
 * The 4x4 integer transform and its inverse (H.264, 8.5.12), and the Hadamard transforms of DC
 * coefficients (8.5.10 and 8.5.11.1).
 *
 * <p>The forward transform works on two blocks side by side. A word holds four signed numbers and
 * is their weighted sum: the first number, plus the second times 2^16, and so on. Adding words
 * therefore adds their numbers. A bias that makes the numbers positive is needed only to extract
 * them.
 */
final class Transform {

  private static final int STRIDE = MacroblockSamples.STRIDE;

  /** Number of words for each block after {@link #forward}. */
  static final int WORDS_PER_BLOCK = 4;

  /**
   * The bias for extracting numbers; above 1530, which is the largest number after the vertical
   * pass.
   */
  private static final int BIAS = 0x1000;

  private static final long EVEN_LANES = 0x0000_FFFF_0000_FFFFL;
  private static final long LOW_HALF = 0xFFFF_FFFFL;

  private final MacroblockSamples source;
  private final long[] evenColumns = new long[4];
  private final long[] oddColumns = new long[4];

  /**
   * Creates a transform for the difference between a source and a prediction.
   *
   * @param source the samples to encode
   */
  Transform(MacroblockSamples source) {
    this.source = source;
  }

  /**
   * Transforms the residual of two blocks.
   *
   * @param block number of the left block
   * @param to receives four words for each block, starting at four times its number; each word is a
   *     column of coefficients, with the topmost coefficient in the lowest bits
   */
  void forward(MacroblockSamples prediction, int block, long[] to) {
    int at = MacroblockSamples.offset(block);
    for (int y = 0; y < 4; y++) {
      long wanted = Swar.load(source.bytes, at + STRIDE * y);
      long predicted = Swar.load(prediction.bytes, at + STRIDE * y);
      evenColumns[y] = (wanted & Swar.LOW_BYTES) - (predicted & Swar.LOW_BYTES);
      oddColumns[y] = ((wanted >>> 8) & Swar.LOW_BYTES) - ((predicted >>> 8) & Swar.LOW_BYTES);
    }
    transformVertically(evenColumns);
    transformVertically(oddColumns);
    transformHorizontally(
        evenColumns[0], oddColumns[0], evenColumns[1], oddColumns[1], to, WORDS_PER_BLOCK * block);
    transformHorizontally(
        evenColumns[2],
        oddColumns[2],
        evenColumns[3],
        oddColumns[3],
        to,
        WORDS_PER_BLOCK * block + WORDS_PER_BLOCK);
  }

  /** Transforms four rows of four numbers vertically, and transposes them. */
  private static void transformVertically(long[] rows) {
    long s03 = rows[0] + rows[3];
    long d03 = rows[0] - rows[3];
    long s12 = rows[1] + rows[2];
    long d12 = rows[1] - rows[2];
    long bias = Swar.broadcast16(BIAS);
    long a = s03 + s12 + bias;
    long b = (d03 << 1) + d12 + bias;
    long c = s03 - s12 + bias;
    long d = d03 - (d12 << 1) + bias;
    long first = (a & EVEN_LANES) | ((b & EVEN_LANES) << 16);
    long second = ((a >>> 16) & EVEN_LANES) | (b & ~EVEN_LANES);
    long third = (c & EVEN_LANES) | ((d & EVEN_LANES) << 16);
    long fourth = ((c >>> 16) & EVEN_LANES) | (d & ~EVEN_LANES);
    rows[0] = (first & LOW_HALF) | (third << 32);
    rows[1] = (second & LOW_HALF) | (fourth << 32);
    rows[2] = (first >>> 32) | (third & ~LOW_HALF);
    rows[3] = (second >>> 32) | (fourth & ~LOW_HALF);
  }

  /** Transforms four columns horizontally. The bias cancels out in all columns but the first. */
  private static void transformHorizontally(
      long p0, long p1, long p2, long p3, long[] to, int offset) {
    long s03 = p0 + p3;
    long d03 = p0 - p3;
    long s12 = p1 + p2;
    long d12 = p1 - p2;
    to[offset] = s03 + s12 - Swar.broadcast16(4 * BIAS);
    to[offset + 1] = (d03 << 1) + d12;
    to[offset + 2] = s03 - s12;
    to[offset + 3] = d03 - (d12 << 1);
  }

  /** Returns the DC coefficient of a block. */
  static int dc(long[] words, int block) {
    return (short) words[WORDS_PER_BLOCK * block];
  }

  /** Sets the DC coefficient of a block to zero. */
  static void clearDc(long[] words, int block) {
    words[WORDS_PER_BLOCK * block] -= (short) words[WORDS_PER_BLOCK * block];
  }

  /** Adds to the prediction the inverse transform of a block that has only a DC coefficient. */
  static void addDcInverse(int dc, MacroblockSamples prediction, int at) {
    int value = (dc + 32) >> 6;
    byte[] samples = prediction.bytes;
    for (int row = at; row < at + 4 * STRIDE; row += STRIDE) {
      samples[row] = clip1((samples[row] & 0xFF) + value);
      samples[row + 1] = clip1((samples[row + 1] & 0xFF) + value);
      samples[row + 2] = clip1((samples[row + 2] & 0xFF) + value);
      samples[row + 3] = clip1((samples[row + 3] & 0xFF) + value);
    }
  }

  /**
   * Adds the inverse transform of a block to the prediction.
   *
   * @param from the 16 coefficients, column by column from {@code offset} on; overwritten
   * @param at offset of the block in the prediction
   */
  static void addInverse(int[] from, int offset, MacroblockSamples prediction, int at) {
    for (int row = offset; row < offset + 4; row++) {
      int s02 = from[row] + from[row + 8];
      int d02 = from[row] - from[row + 8];
      int d13 = (from[row + 4] >> 1) - from[row + 12];
      int s13 = from[row + 4] + (from[row + 12] >> 1);
      from[row] = s02 + s13;
      from[row + 4] = d02 + d13;
      from[row + 8] = d02 - d13;
      from[row + 12] = s02 - s13;
    }
    byte[] samples = prediction.bytes;
    for (int x = 0; x < 4; x++) {
      int column = offset + 4 * x;
      int s02 = from[column] + from[column + 2] + 32;
      int d02 = from[column] - from[column + 2] + 32;
      int d13 = (from[column + 1] >> 1) - from[column + 3];
      int s13 = from[column + 1] + (from[column + 3] >> 1);
      int to = at + x;
      samples[to] = clip1((samples[to] & 0xFF) + ((s02 + s13) >> 6));
      to += STRIDE;
      samples[to] = clip1((samples[to] & 0xFF) + ((d02 + d13) >> 6));
      to += STRIDE;
      samples[to] = clip1((samples[to] & 0xFF) + ((d02 - d13) >> 6));
      to += STRIDE;
      samples[to] = clip1((samples[to] & 0xFF) + ((s02 - s13) >> 6));
    }
  }

  private static byte clip1(int value) {
    return (byte) Math.max(0, Math.min(255, value));
  }

  /** Applies the 4x4 Hadamard transform; applying it twice multiplies by 16. */
  static void hadamard4x4(int[] values) {
    for (int i = 0; i < 16; i += 4) {
      butterfly(values, i, 1);
    }
    for (int i = 0; i < 4; i++) {
      butterfly(values, i, 4);
    }
  }

  private static void butterfly(int[] values, int first, int step) {
    int a = values[first];
    int b = values[first + step];
    int c = values[first + 2 * step];
    int d = values[first + 3 * step];
    values[first] = a + b + c + d;
    values[first + step] = a + b - c - d;
    values[first + 2 * step] = a - b - c + d;
    values[first + 3 * step] = a - b + c - d;
  }

  /** Applies the 2x2 Hadamard transform from an offset on; applying it twice multiplies by 4. */
  static void hadamard2x2(int[] values, int offset) {
    int a = values[offset];
    int b = values[offset + 1];
    int c = values[offset + 2];
    int d = values[offset + 3];
    values[offset] = a + b + c + d;
    values[offset + 1] = a - b + c - d;
    values[offset + 2] = a + b - c - d;
    values[offset + 3] = a - b - c + d;
  }
}
