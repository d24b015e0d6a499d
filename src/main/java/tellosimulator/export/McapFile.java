package tellosimulator.export;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/**
 * Writes messages in JSON as an MCAP file, which Foxglove and PlotJuggler read: without chunks and
 * without an index, as the format allows. For one thread.
 *
 * <p>Source: MCAP format specification, version 0.
 */
final class McapFile {

  private static final byte[] MAGIC = {(byte) 0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};

  private static final int HEADER = 0x01;
  private static final int FOOTER = 0x02;
  private static final int SCHEMA = 0x03;
  private static final int CHANNEL = 0x04;
  private static final int MESSAGE = 0x05;
  private static final int DATA_END = 0x0f;

  private final OutputStream out;
  private int channels;
  private int messages;

  /**
   * Begins a file.
   *
   * @param library what writes it
   */
  McapFile(OutputStream out, String library) throws IOException {
    this.out = out;
    out.write(MAGIC);
    write(HEADER, new Content().text("").text(library));
  }

  /**
   * Adds a channel for messages of one form.
   *
   * @param schema JSON schema of a message
   * @return its number
   */
  int channel(String topic, String schemaName, String schema) throws IOException {
    channels++;
    byte[] bytes = schema.getBytes(StandardCharsets.UTF_8);
    write(
        SCHEMA, new Content().number16(channels).text(schemaName).text("jsonschema").bytes(bytes));
    write(
        CHANNEL,
        new Content().number16(channels).number16(channels).text(topic).text("json").number32(0));
    return channels;
  }

  /**
   * Adds a message.
   *
   * @param nanos when, since 1970
   */
  void message(int channel, long nanos, String json) throws IOException {
    write(
        MESSAGE,
        new Content()
            .number16(channel)
            .number32(messages++)
            .number64(nanos)
            .number64(nanos)
            .raw(json.getBytes(StandardCharsets.UTF_8)));
  }

  /** Ends the file. */
  void end() throws IOException {
    write(DATA_END, new Content().number32(0)); // no checksum
    write(FOOTER, new Content().number64(0).number64(0).number32(0)); // no summary
    out.write(MAGIC);
  }

  private void write(int opcode, Content content) throws IOException {
    ByteBuffer head = ByteBuffer.allocate(9).order(ByteOrder.LITTLE_ENDIAN).put((byte) opcode);
    out.write(head.putLong(content.buffer.position()).array());
    out.write(content.buffer.array(), 0, content.buffer.position());
  }

  /** What is in a record. */
  private static final class Content {

    private ByteBuffer buffer = ByteBuffer.allocate(256).order(ByteOrder.LITTLE_ENDIAN);

    private ByteBuffer room(int bytes) {
      if (buffer.remaining() < bytes) {
        int capacity = Math.max(2 * buffer.capacity(), buffer.position() + bytes);
        ByteBuffer larger = ByteBuffer.allocate(capacity).order(ByteOrder.LITTLE_ENDIAN);
        buffer = larger.put(buffer.flip());
      }
      return buffer;
    }

    Content number16(int value) {
      room(2).putShort((short) value);
      return this;
    }

    Content number32(int value) {
      room(4).putInt(value);
      return this;
    }

    Content number64(long value) {
      room(8).putLong(value);
      return this;
    }

    Content raw(byte[] bytes) {
      room(bytes.length).put(bytes);
      return this;
    }

    Content bytes(byte[] bytes) {
      return number32(bytes.length).raw(bytes);
    }

    Content text(String text) {
      return bytes(text.getBytes(StandardCharsets.UTF_8));
    }
  }
}
