package tellosimulator.video.codec;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.util.Arrays;

/**
 * Writes the bits of a raw byte sequence payload (RBSP), most significant bit first. JCodec's own
 * writer goes through a buffer bit by bit; this one stores eight bytes at once, and the next call
 * overwrites those that are not yet complete.
 */
final class BitWriter {

  private static final VarHandle LONGS =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.BIG_ENDIAN);

  /** Decided: more than any frame needs that is not noise. */
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

  /** Ensures room for that many more bytes, so that {@link #put} need not check. */
  void reserve(int more) {
    if (size + more + Long.BYTES > bytes.length) {
      bytes = Arrays.copyOf(bytes, 2 * bytes.length + more);
    }
  }

  /**
   * Writes u(n): the lowest bits of a value, whose higher bits must be zero.
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

  /** Writes ue(v), an unsigned Exp-Golomb code (H.264, 9.1); the value is not negative. */
  void putUe(int value) {
    put(value + 1, ueLength(value));
  }

  /** Writes se(v), a signed Exp-Golomb code (H.264, 9.1.1). */
  void putSe(int value) {
    putUe(codeNum(value));
  }

  /** The length of {@link #putSe} in bits. */
  static int seLength(int value) {
    return ueLength(codeNum(value));
  }

  /** The length of {@link #putUe} in bits. */
  static int ueLength(int value) {
    return 63 - 2 * Integer.numberOfLeadingZeros(value + 1);
  }

  /** codeNum of a signed value: H.264, table 9-3. */
  private static int codeNum(int value) {
    return value > 0 ? 2 * value - 1 : -2 * value;
  }

  /** Writes rbsp_trailing_bits: a one, then zeros up to the next byte; nothing may follow. */
  void putTrailingBits() {
    put(1, 1);
    put(0, -pendingBits & 7);
  }

  /** The number of bits written. */
  int bitCount() {
    return 8 * size + pendingBits;
  }

  /** The bytes written, not a copy; complete after {@link #putTrailingBits}. */
  byte[] bytes() {
    return bytes;
  }

  /** The number of complete bytes. */
  int size() {
    return size;
  }
}
