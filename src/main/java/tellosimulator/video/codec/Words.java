package tellosimulator.video.codec;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;

/**
 * Eight pixels at once: bytes without sign in a long, the first one lowest. Plain arithmetic on
 * longs compares and averages them several times faster than a loop over bytes does.
 */
final class Words {

  /** Each second byte: four lanes of 16 bits. */
  static final long LANES = 0x00FF_00FF_00FF_00FFL;

  private static final long ONES = 0x0001_0001_0001_0001L;
  private static final long HIGH_BITS = 0x8080_8080_8080_8080L;

  private static final VarHandle LONGS =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);

  private Words() {}

  static long get(byte[] bytes, int index) {
    return (long) LONGS.get(bytes, index);
  }

  static void put(byte[] bytes, int index, long word) {
    LONGS.set(bytes, index, word);
  }

  /** Eight times the same byte. */
  static long fill(int value) {
    return (value & 0xFF) * 0x0101_0101_0101_0101L;
  }

  /** Four lanes of 16 bits with the same value without sign. */
  static long lanes(int value) {
    return value * ONES;
  }

  /** The mean of each two bytes, rounded up. */
  static long average(long a, long b) {
    return (a | b) - (((a ^ b) & 0xFEFE_FEFE_FEFE_FEFEL) >>> 1);
  }

  /**
   * The absolute differences of eight pixels in four lanes of 16 bits: the lowest lane is the sum
   * of the first two, and so on. Lanes may be added up 128 times.
   */
  static long differences(long a, long b) {
    long unlike = a ^ b;
    long minus = (a | HIGH_BITS) - (b & ~HIGH_BITS);
    long less = ((unlike & b) | ~(unlike | minus)) & HIGH_BITS;
    long one = less >>> 7;
    long absolute = (minus ^ (~unlike & HIGH_BITS) ^ ((less << 1) - one)) + one;
    return (absolute & LANES) + ((absolute >>> 8) & LANES);
  }

  /** The sum of four lanes, below 65536. */
  static int sum(long lanes) {
    return (int) ((lanes * ONES) >>> 48);
  }
}
