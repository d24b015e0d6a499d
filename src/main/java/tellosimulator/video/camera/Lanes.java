package tellosimulator.video.camera;

/**
 * A packed pixel spread over a long, 16 bits a channel. So one multiplication weighs all four
 * channels: 255 times a weight of 256 still fits. From the lowest: third channel, first channel,
 * second channel, opacity.
 */
final class Lanes {

  /** The 8 bits of each channel that count. */
  static final long MASK = 0x00ff00ff00ff00ffL;

  private Lanes() {}

  static long of(int packed) {
    long low = packed & 0xffffffffL;
    return (low | (low << 24)) & MASK;
  }

  static int packed(long lanes) {
    return (int) (lanes | (lanes >>> 24));
  }

  /** The mean of weighed lanes, whose weights add up to 256. */
  static long mean(long sum) {
    return (sum >>> 8) & MASK;
  }
}
