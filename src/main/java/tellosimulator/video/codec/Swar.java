package tellosimulator.video.codec;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;

/**
 * SIMD within a register. A long contains eight unsigned bytes, the first one lowest, or four lanes
 * of 16 bits. Plain arithmetic on longs compares and averages samples several times faster than a
 * loop over bytes.
 */
final class Swar {

  /** The low byte of each 16-bit lane. */
  static final long LOW_BYTES = 0x00FF_00FF_00FF_00FFL;

  private static final long ONES = 0x0001_0001_0001_0001L;
  private static final long HIGH_BITS = 0x8080_8080_8080_8080L;

  private static final VarHandle LONGS =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);

  private Swar() {}

  static long load(byte[] bytes, int index) {
    return (long) LONGS.get(bytes, index);
  }

  static void store(byte[] bytes, int index, long word) {
    LONGS.set(bytes, index, word);
  }

  /** Returns eight copies of a byte. */
  static long broadcast(int value) {
    return (value & 0xFF) * 0x0101_0101_0101_0101L;
  }

  /** Returns four lanes with the same unsigned value. */
  static long broadcast16(int value) {
    return value * ONES;
  }

  /** Returns the averages of eight pairs of bytes, rounded up. */
  static long average(long a, long b) {
    return (a | b) - (((a ^ b) & 0xFEFE_FEFE_FEFE_FEFEL) >>> 1);
  }

  /**
   * Returns the absolute differences of eight pairs of bytes, added up in pairs: the lowest lane
   * holds the sum of the first two differences, and so on. Up to 128 results may be added up.
   */
  static long absoluteDifferences(long a, long b) {
    long xor = a ^ b;
    long minus = (a | HIGH_BITS) - (b & ~HIGH_BITS);
    long borrow = ((xor & b) | ~(xor | minus)) & HIGH_BITS;
    long one = borrow >>> 7;
    long absolute = (minus ^ (~xor & HIGH_BITS) ^ ((borrow << 1) - one)) + one;
    return (absolute & LOW_BYTES) + ((absolute >>> 8) & LOW_BYTES);
  }

  /** Returns the sum of four lanes; the sum must be below 65536. */
  static int horizontalSum(long lanes) {
    return (int) ((lanes * ONES) >>> 48);
  }
}
