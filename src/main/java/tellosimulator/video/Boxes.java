package tellosimulator.video;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;

/**
 * Builds the boxes of an MP4 file, each preceded by its size and type (ISO/IEC 14496-12, 4.2).
 * Numbers are big-endian. Thread-safe.
 */
final class Boxes {

  /** Size of the header of a box: its size and its type [bytes]. */
  static final int HEADER = 8;

  private Boxes() {}

  static byte[] box(String type, byte[]... parts) {
    byte[] content = joined(parts);
    return joined(u32(HEADER + content.length), ascii(type), content);
  }

  /** Builds a box that starts with a version and flags. */
  static byte[] fullBox(String type, int versionAndFlags, byte[]... parts) {
    return box(type, u32(versionAndFlags), joined(parts));
  }

  static byte[] joined(byte[]... parts) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    for (byte[] part : parts) {
      all.writeBytes(part);
    }
    return all.toByteArray();
  }

  static byte[] u8(long... values) {
    return numbers(1, values);
  }

  static byte[] u16(long... values) {
    return numbers(2, values);
  }

  static byte[] u32(long... values) {
    return numbers(4, values);
  }

  static byte[] u64(long... values) {
    return numbers(8, values);
  }

  private static byte[] numbers(int size, long... values) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    for (long value : values) {
      for (int shift = 8 * (size - 1); shift >= 0; shift -= 8) {
        all.write((int) (value >> shift));
      }
    }
    return all.toByteArray();
  }

  static byte[] ascii(String text) {
    return text.getBytes(StandardCharsets.US_ASCII);
  }

  static byte[] zeros(int count) {
    return new byte[count];
  }
}
