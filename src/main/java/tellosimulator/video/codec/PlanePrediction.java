package tellosimulator.video.codec;

/** The prediction by a plane through the row above and the column at the left (H.264, 8.3.3.4). */
final class PlanePrediction {

  private PlanePrediction() {}

  /**
   * Fills a square, or some of its rows.
   *
   * @param first the first row to fill
   * @param step from one row to fill to the next
   * @param at where the square begins in the plane
   * @param size 16 for luma, 8 for colour
   * @param offset where the square begins in what is filled
   */
  static void predict(Plane from, int at, int size, int first, int step, byte[] to, int offset) {
    int factor = size == 16 ? 5 : 34;
    int half = size / 2;
    int above = at - from.stride;
    int rightwards = (slope(from.bytes, above + half - 1, 1, half) * factor + 32) >> 6;
    int downwards =
        (slope(from.bytes, at - 1 + (half - 1) * from.stride, from.stride, half) * factor + 32)
            >> 6;
    int corners =
        (from.bytes[above + size - 1] & 0xFF)
            + (from.bytes[at - 1 + (size - 1) * from.stride] & 0xFF);
    int corner = 16 * corners + 16 - (half - 1) * (rightwards + downwards);
    for (int y = first; y < size; y += step) {
      int value = corner + y * downwards;
      for (int x = 0; x < size; x++) {
        to[offset + Samples.STRIDE * y + x] = (byte) Math.max(0, Math.min(255, value >> 5));
        value += rightwards;
      }
    }
  }

  /** How much pixels rise along a line, farther ones weighing more. */
  private static int slope(byte[] pixels, int middle, int step, int half) {
    int sum = 0;
    for (int i = 1; i <= half; i++) {
      sum += i * ((pixels[middle + i * step] & 0xFF) - (pixels[middle - i * step] & 0xFF));
    }
    return sum;
  }
}
