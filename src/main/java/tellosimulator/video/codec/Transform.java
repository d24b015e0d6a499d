package tellosimulator.video.codec;

/**
 * H.264's integer transform of blocks of 4 by 4, there and back, and the one of their first
 * coefficients.
 *
 * <p>Forward works on two blocks beside each other, four numbers at once. A word stands for four
 * numbers with sign: the sum of the first, the second times 2^16, and so on. So words add up as
 * their numbers do; only taking numbers out needs a bias that makes them positive.
 */
final class Transform {

  private static final int STRIDE = Samples.STRIDE;

  /** Words that a block has after {@link #forward}. */
  static final int WORDS = 4;

  /** Above 1530, the largest number after the first half of the transform. */
  private static final int BIAS = 0x1000;

  private static final long EVEN_LANES = 0x0000_FFFF_0000_FFFFL;
  private static final long LOW_HALF = 0xFFFF_FFFFL;

  private final Samples source;
  private final long[] even = new long[4];
  private final long[] odd = new long[4];

  /**
   * @param source what is transformed is its difference from a prediction
   */
  Transform(Samples source) {
    this.source = source;
  }

  /**
   * Transforms the difference between what two blocks are and what was predicted.
   *
   * @param block the left one
   * @param to gets four words for each block, at four times its number: a column of coefficients
   *     each, from the top
   */
  void forward(Samples prediction, int block, long[] to) {
    int at = Samples.at(block);
    for (int y = 0; y < 4; y++) {
      long wanted = Words.get(source.bytes, at + STRIDE * y);
      long predicted = Words.get(prediction.bytes, at + STRIDE * y);
      even[y] = (wanted & Words.LANES) - (predicted & Words.LANES);
      odd[y] = ((wanted >>> 8) & Words.LANES) - ((predicted >>> 8) & Words.LANES);
    }
    columns(even);
    columns(odd);
    rows(even[0], odd[0], even[1], odd[1], to, WORDS * block);
    rows(even[2], odd[2], even[3], odd[3], to, WORDS * block + WORDS);
  }

  /** Transforms four rows of four numbers downwards and turns rows into columns. */
  private static void columns(long[] rows) {
    long outer = rows[0] + rows[3];
    long outerGap = rows[0] - rows[3];
    long inner = rows[1] + rows[2];
    long innerGap = rows[1] - rows[2];
    long bias = Words.lanes(BIAS);
    long a = outer + inner + bias;
    long b = (outerGap << 1) + innerGap + bias;
    long c = outer - inner + bias;
    long d = outerGap - (innerGap << 1) + bias;
    long first = (a & EVEN_LANES) | ((b & EVEN_LANES) << 16);
    long second = ((a >>> 16) & EVEN_LANES) | (b & ~EVEN_LANES);
    long third = (c & EVEN_LANES) | ((d & EVEN_LANES) << 16);
    long fourth = ((c >>> 16) & EVEN_LANES) | (d & ~EVEN_LANES);
    rows[0] = (first & LOW_HALF) | (third << 32);
    rows[1] = (second & LOW_HALF) | (fourth << 32);
    rows[2] = (first >>> 32) | (third & ~LOW_HALF);
    rows[3] = (second >>> 32) | (fourth & ~LOW_HALF);
  }

  /** Transforms four columns to the right; all but the first lose their bias by themselves. */
  private static void rows(long p0, long p1, long p2, long p3, long[] to, int offset) {
    long outer = p0 + p3;
    long outerGap = p0 - p3;
    long inner = p1 + p2;
    long innerGap = p1 - p2;
    to[offset] = outer + inner - Words.lanes(4 * BIAS);
    to[offset + 1] = (outerGap << 1) + innerGap;
    to[offset + 2] = outer - inner;
    to[offset + 3] = outerGap - (innerGap << 1);
  }

  /** The first coefficient of a block. */
  static int first(long[] words, int block) {
    return (short) words[WORDS * block];
  }

  /** Sets the first coefficient of a block to 0. */
  static void dropFirst(long[] words, int block) {
    words[WORDS * block] -= (short) words[WORDS * block];
  }

  /** Adds what a first coefficient alone stands for to the prediction. */
  static void addFirst(int coefficient, Samples prediction, int at) {
    int value = (coefficient + 32) >> 6;
    byte[] pixels = prediction.bytes;
    for (int row = at; row < at + 4 * STRIDE; row += STRIDE) {
      pixels[row] = clip((pixels[row] & 0xFF) + value);
      pixels[row + 1] = clip((pixels[row + 1] & 0xFF) + value);
      pixels[row + 2] = clip((pixels[row + 2] & 0xFF) + value);
      pixels[row + 3] = clip((pixels[row + 3] & 0xFF) + value);
    }
  }

  /**
   * Adds what coefficients stand for to the prediction.
   *
   * @param from 16 coefficients column by column from offset on; they are changed
   * @param at where the block begins in the prediction
   */
  static void addInverse(int[] from, int offset, Samples prediction, int at) {
    for (int row = offset; row < offset + 4; row++) {
      int even = from[row] + from[row + 8];
      int evenGap = from[row] - from[row + 8];
      int oddGap = (from[row + 4] >> 1) - from[row + 12];
      int odd = from[row + 4] + (from[row + 12] >> 1);
      from[row] = even + odd;
      from[row + 4] = evenGap + oddGap;
      from[row + 8] = evenGap - oddGap;
      from[row + 12] = even - odd;
    }
    byte[] pixels = prediction.bytes;
    for (int x = 0; x < 4; x++) {
      int column = offset + 4 * x;
      int even = from[column] + from[column + 2] + 32;
      int evenGap = from[column] - from[column + 2] + 32;
      int oddGap = (from[column + 1] >> 1) - from[column + 3];
      int odd = from[column + 1] + (from[column + 3] >> 1);
      int to = at + x;
      pixels[to] = clip((pixels[to] & 0xFF) + ((even + odd) >> 6));
      to += STRIDE;
      pixels[to] = clip((pixels[to] & 0xFF) + ((evenGap + oddGap) >> 6));
      to += STRIDE;
      pixels[to] = clip((pixels[to] & 0xFF) + ((evenGap - oddGap) >> 6));
      to += STRIDE;
      pixels[to] = clip((pixels[to] & 0xFF) + ((even - odd) >> 6));
    }
  }

  private static byte clip(int value) {
    return (byte) Math.max(0, Math.min(255, value));
  }

  /** Transforms 4 by 4 numbers; twice is 16 times the same. */
  static void hadamard(int[] numbers) {
    for (int i = 0; i < 16; i += 4) {
      butterfly(numbers, i, 1);
    }
    for (int i = 0; i < 4; i++) {
      butterfly(numbers, i, 4);
    }
  }

  private static void butterfly(int[] numbers, int first, int step) {
    int a = numbers[first];
    int b = numbers[first + step];
    int c = numbers[first + 2 * step];
    int d = numbers[first + 3 * step];
    numbers[first] = a + b + c + d;
    numbers[first + step] = a + b - c - d;
    numbers[first + 2 * step] = a - b - c + d;
    numbers[first + 3 * step] = a - b + c - d;
  }

  /** Transforms 2 by 2 numbers from an offset on; twice is 4 times the same. */
  static void smallHadamard(int[] numbers, int offset) {
    int a = numbers[offset];
    int b = numbers[offset + 1];
    int c = numbers[offset + 2];
    int d = numbers[offset + 3];
    numbers[offset] = a + b + c + d;
    numbers[offset + 1] = a - b + c - d;
    numbers[offset + 2] = a + b - c - d;
    numbers[offset + 3] = a - b - c + d;
  }
}
