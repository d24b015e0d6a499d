package tellosimulator.video.codec;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.util.Arrays;

/**
 * Bits one after another, the highest of each byte first. JCodec's own writer goes through a buffer
 * bit by bit; this one writes four bytes at once.
 */
final class BitWriter {

  private static final VarHandle INTS =
      MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.BIG_ENDIAN);

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
    if (size + more > bytes.length) {
      bytes = Arrays.copyOf(bytes, 2 * bytes.length + more);
    }
  }

  /**
   * Writes the lowest bits of a value; the higher ones must be zero.
   *
   * @param length up to 32
   */
  void put(int value, int length) {
    pending = (pending << length) | (value & 0xFFFF_FFFFL);
    pendingBits += length;
    if (pendingBits >= 32) {
      pendingBits -= 32;
      INTS.set(bytes, size, (int) (pending >>> pendingBits));
      size += 4;
    }
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
    while (pendingBits > 0) {
      pendingBits -= 8;
      bytes[size++] = (byte) (pending >>> pendingBits);
    }
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
