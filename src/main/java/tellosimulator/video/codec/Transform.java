package tellosimulator.video.codec;

/**
 * H.264's integer transform of blocks of 4 by 4, there and back, and the one of their first
 * coefficients. Coefficients lie row by row in arrays, 16 a block.
 */
final class Transform {

  private static final int STRIDE = Samples.STRIDE;

  private Transform() {}

  /**
   * Transforms the difference between what a block is and what was predicted.
   *
   * @param at where the block begins in both
   * @param to gets 16 coefficients from offset on
   */
  static void forward(Samples source, Samples prediction, int at, int[] to, int offset) {
    byte[] a = source.bytes;
    byte[] b = prediction.bytes;
    for (int y = 0; y < 4; y++) {
      int from = at + STRIDE * y;
      int p0 = (a[from] & 0xFF) - (b[from] & 0xFF);
      int p1 = (a[from + 1] & 0xFF) - (b[from + 1] & 0xFF);
      int p2 = (a[from + 2] & 0xFF) - (b[from + 2] & 0xFF);
      int p3 = (a[from + 3] & 0xFF) - (b[from + 3] & 0xFF);
      int outer = p0 + p3;
      int outerGap = p0 - p3;
      int inner = p1 + p2;
      int innerGap = p1 - p2;
      int row = offset + 4 * y;
      to[row] = outer + inner;
      to[row + 1] = 2 * outerGap + innerGap;
      to[row + 2] = outer - inner;
      to[row + 3] = outerGap - 2 * innerGap;
    }
    for (int x = offset; x < offset + 4; x++) {
      int outer = to[x] + to[x + 12];
      int outerGap = to[x] - to[x + 12];
      int inner = to[x + 4] + to[x + 8];
      int innerGap = to[x + 4] - to[x + 8];
      to[x] = outer + inner;
      to[x + 4] = 2 * outerGap + innerGap;
      to[x + 8] = outer - inner;
      to[x + 12] = outerGap - 2 * innerGap;
    }
  }

  /**
   * Adds what coefficients stand for to the prediction.
   *
   * @param from 16 coefficients from offset on; they are changed
   * @param at where the block begins in the prediction
   */
  static void addInverse(int[] from, int offset, Samples prediction, int at) {
    for (int row = offset; row < offset + 16; row += 4) {
      int even = from[row] + from[row + 2];
      int evenGap = from[row] - from[row + 2];
      int oddGap = (from[row + 1] >> 1) - from[row + 3];
      int odd = from[row + 1] + (from[row + 3] >> 1);
      from[row] = even + odd;
      from[row + 1] = evenGap + oddGap;
      from[row + 2] = evenGap - oddGap;
      from[row + 3] = even - odd;
    }
    byte[] pixels = prediction.bytes;
    for (int x = 0; x < 4; x++) {
      int column = offset + x;
      int even = from[column] + from[column + 8] + 32;
      int evenGap = from[column] - from[column + 8] + 32;
      int oddGap = (from[column + 4] >> 1) - from[column + 12];
      int odd = from[column + 4] + (from[column + 12] >> 1);
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
