package tellosimulator.video;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/**
 * Writes the boxes of an MP4 file, each with its size and type before it (ISO/IEC 14496-12, 4.2).
 * Not for several threads.
 */
final class BoxWriter {

  private static final int HEADER = 8;

  private ByteBuffer bytes = ByteBuffer.allocate(1 << 12);

  /** Writes the content of a box. */
  interface Content {
    void write();
  }

  /** A box with what {@code content} writes. */
  BoxWriter box(String type, Content content) {
    int start = bytes.position();
    u32(0).ascii(type);
    content.write();
    bytes.putInt(start, bytes.position() - start);
    return this;
  }

  /** A box that begins with a version and flags. */
  BoxWriter fullBox(String type, int versionAndFlags, Content content) {
    return box(
        type,
        () -> {
          u32(versionAndFlags);
          content.write();
        });
  }

  BoxWriter u8(int value) {
    room(1).put((byte) value);
    return this;
  }

  BoxWriter u16(int value) {
    room(2).putShort((short) value);
    return this;
  }

  BoxWriter u32(long value) {
    room(4).putInt((int) value);
    return this;
  }

  BoxWriter u64(long value) {
    room(8).putLong(value);
    return this;
  }

  BoxWriter ascii(String text) {
    return bytes(text.getBytes(StandardCharsets.US_ASCII));
  }

  BoxWriter bytes(byte... values) {
    room(values.length).put(values);
    return this;
  }

  BoxWriter bytes(ByteBuffer values) {
    room(values.remaining()).put(values.duplicate());
    return this;
  }

  BoxWriter zeros(int count) {
    return bytes(new byte[count]);
  }

  /** How many bytes have been written. */
  int size() {
    return bytes.position();
  }

  /** Writes four bytes anew. */
  void set(int position, int value) {
    bytes.putInt(position, value);
  }

  /** What was written. */
  ByteBuffer toBuffer() {
    return bytes.duplicate().flip();
  }

  private ByteBuffer room(int count) {
    if (bytes.remaining() < count) {
      int capacity = 2 * bytes.capacity() + count + HEADER;
      bytes = ByteBuffer.allocate(capacity).put(bytes.flip());
    }
    return bytes;
  }
}
