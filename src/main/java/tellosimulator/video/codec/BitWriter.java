package tellosimulator.video.codec;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.util.Arrays;

/**
 * Writes the bits of a raw byte sequence payload (RBSP), most significant bit first. Each call
 * stores eight bytes at once; the next call overwrites the incomplete bytes.
 */
final class BitWriter {

  private static final VarHandle LONGS =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.BIG_ENDIAN);

  /**
   * Initial size of the buffer [bytes]. Decided: more than any frame needs, except frames of noise.
   */
  private static final int INITIAL_CAPACITY = 1 << 17;

  private byte[] bytes = new byte[INITIAL_CAPACITY];
  private int size;
  private long pending;
  private int pendingBits;

  void clear() {
    size = 0;
    pending = 0;
    pendingBits = 0;
  }

  /**
   * Ensures that there is space for a number of additional bytes, so that {@link #put} need not
   * check for it.
   */
  void reserve(int more) {
    if (size + more + Long.BYTES > bytes.length) {
      bytes = Arrays.copyOf(bytes, 2 * bytes.length + more);
    }
  }

  /**
   * Writes u(n), the lowest bits of a value. The higher bits of the value must be zero.
   *
   * @param length n, up to 32
   */
  void put(int value, int length) {
    pendingBits += length;
    pending |= (value & 0xFFFF_FFFFL) << -pendingBits;
    LONGS.set(bytes, size, pending);
    pending <<= pendingBits & ~7;
    size += pendingBits >> 3;
    pendingBits &= 7;
  }

  /** Writes ue(v), an unsigned Exp-Golomb code (H.264, 9.1). The value must not be negative. */
  void putUe(int value) {
    put(value + 1, ueLength(value));
  }

  /** Writes se(v), a signed Exp-Golomb code (H.264, 9.1.1). */
  void putSe(int value) {
    putUe(codeNum(value));
  }

  /** Returns the length that {@link #putSe} writes for a value [bit]. */
  static int seLength(int value) {
    return ueLength(codeNum(value));
  }

  /** Returns the length that {@link #putUe} writes for a value [bit]. */
  static int ueLength(int value) {
    return 63 - 2 * Integer.numberOfLeadingZeros(value + 1);
  }

  /** Returns the codeNum of a signed value (H.264, table 9-3). */
  private static int codeNum(int value) {
    return value > 0 ? 2 * value - 1 : -2 * value;
  }

  /**
   * Writes rbsp_trailing_bits: a one, followed by zeros up to the next byte boundary. Nothing may
   * be written afterwards.
   */
  void putTrailingBits() {
    put(1, 1);
    put(0, -pendingBits & 7);
  }

  /** The number of bits written. */
  int bitCount() {
    return 8 * size + pendingBits;
  }

  /** The written bytes themselves, not a copy. Complete only after {@link #putTrailingBits}. */
  byte[] bytes() {
    return bytes;
  }

  /** The number of complete bytes. */
  int size() {
    return size;
  }
}
