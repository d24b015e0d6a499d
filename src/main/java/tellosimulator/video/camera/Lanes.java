package tellosimulator.video.camera;

/**
 * A packed pixel spread over a long, 16 bits a channel. So one multiplication weighs all four
 * channels: 255 times a weight of 256 still fits. From the lowest: third channel, first channel,
 * second channel, opacity.
 */
final class Lanes {

  /** Where the first channel is: so many bits above the lowest. */
  static final int FIRST = 16;

  static final int SECOND = 32;
  static final int THIRD = 0;
  static final int OPACITY = 48;

  /** The 8 bits of each channel that count. */
  static final long MASK = 0x00ff00ff00ff00ffL;

  private Lanes() {}

  static long of(int packed) {
    long low = packed & 0xffffffffL;
    return (low | (low << 24)) & MASK;
  }

  /** The mean of weighed lanes, whose weights add up to 256. */
  static long mean(long sum) {
    return (sum >>> 8) & MASK;
  }
}
