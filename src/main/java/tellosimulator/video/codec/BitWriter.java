package tellosimulator.video.codec;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.util.Arrays;

/**
 * Bits one after another, the highest of each byte first. JCodec's own writer goes through a buffer
 * bit by bit; this one writes eight bytes at once, of which the next call overwrites those that are
 * not complete.
 */
final class BitWriter {

  private static final VarHandle LONGS =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.BIG_ENDIAN);

  /** Decided: more than any picture needs that is not noise. */
  private static final int FIRST_CAPACITY = 1 << 17;

  private byte[] bytes = new byte[FIRST_CAPACITY];
  private int size;
  private long pending;
  private int pendingBits;

  void clear() {
    size = 0;
    pending = 0;
    pendingBits = 0;
  }

  /** Makes room for that many bytes, so that writing them need not ask. */
  void reserve(int more) {
    if (size + more + Long.BYTES > bytes.length) {
      bytes = Arrays.copyOf(bytes, 2 * bytes.length + more);
    }
  }

  /**
   * Writes the lowest bits of a value; the higher ones must be zero.
   *
   * @param length up to 32
   */
  void put(int value, int length) {
    pendingBits += length;
    pending |= (value & 0xFFFF_FFFFL) << -pendingBits;
    LONGS.set(bytes, size, pending);
    pending <<= pendingBits & ~7;
    size += pendingBits >> 3;
    pendingBits &= 7;
  }

  /** An Exp-Golomb code: short for small values; not negative. */
  void putUnsigned(int value) {
    put(value + 1, unsignedLength(value));
  }

  /** An Exp-Golomb code for values with a sign. */
  void putSigned(int value) {
    putUnsigned(folded(value));
  }

  /** How many bits {@link #putSigned} writes. */
  static int signedLength(int value) {
    return unsignedLength(folded(value));
  }

  /** How many bits {@link #putUnsigned} writes. */
  static int unsignedLength(int value) {
    return 63 - 2 * Integer.numberOfLeadingZeros(value + 1);
  }

  private static int folded(int value) {
    return value > 0 ? 2 * value - 1 : -2 * value;
  }

  /** A one and zeros up to the next byte; nothing may follow. */
  void finish() {
    put(1, 1);
    put(0, -pendingBits & 7);
  }

  /** How many bits were written. */
  int bits() {
    return 8 * size + pendingBits;
  }

  /** What was written, not a copy; complete after {@link #finish}. */
  byte[] bytes() {
    return bytes;
  }

  /** How many bytes are complete. */
  int size() {
    return size;
  }
}
