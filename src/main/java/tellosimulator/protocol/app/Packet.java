package tellosimulator.protocol.app;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.Optional;

/**
 * A packet of the app's protocol: a frame with two checksums around a payload. Its arrays must not
 * be modified. Measured: a radio capture (m6c7l/dji-ryze-tello); layout and checksums agree in
 * TelloPy, gobot, SMerrony/tello and TelloLib.
 *
 * @param kind who sends the packet, and whether it asks, answers or orders
 * @param id the number of the message; {@link MessageId} lists those that are known
 * @param sequence a number by which an answer is matched with its question, 16 bits
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
record Packet(int kind, int id, int sequence, byte[] payload) {

  /** The first byte of each packet. */
  static final byte MARK = (byte) 0xcc;

  /** Kind of a packet that the drone sends of its own accord. */
  static final int NOTIFICATION = 0x88;

  /** Length of the frame around a payload [bytes]. */
  static final int FRAME = 11;

  /** Length of the header, in front of the payload [bytes]. */
  private static final int HEADER = 9;

  /** The bits of a kind that tell the direction. */
  private static final int DIRECTION = 0xc0;

  private static final int KIND_SHIFT = 3;
  private static final int KIND_MASK = 7;
  private static final int LENGTH_SHIFT = 3;

  /** Returns the packet in a datagram; empty if its length or one of its checksums is wrong. */
  static Optional<Packet> parse(byte[] datagram) {
    if (datagram.length < FRAME || datagram[0] != MARK) {
      return Optional.empty();
    }
    ByteBuffer in = ByteBuffer.wrap(datagram).order(ByteOrder.LITTLE_ENDIAN);
    int length = Short.toUnsignedInt(in.getShort(1)) >> LENGTH_SHIFT;
    boolean whole =
        length == datagram.length
            && Byte.toUnsignedInt(in.get(3)) == Checksum.ofHeader(datagram)
            && Short.toUnsignedInt(in.getShort(length - 2)) == Checksum.of(datagram, length - 2);
    return whole
        ? Optional.of(
            new Packet(
                Byte.toUnsignedInt(in.get(4)),
                Short.toUnsignedInt(in.getShort(5)),
                Short.toUnsignedInt(in.getShort(7)),
                Arrays.copyOfRange(datagram, HEADER, length - 2)))
        : Optional.empty();
  }

  /** Returns the packet as a datagram. */
  byte[] bytes() {
    int length = FRAME + payload.length;
    byte[] bytes = new byte[length];
    ByteBuffer out = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    out.put(MARK).putShort((short) (length << LENGTH_SHIFT));
    out.put((byte) Checksum.ofHeader(bytes)).put((byte) kind);
    out.putShort((short) id).putShort((short) sequence).put(payload);
    out.putShort((short) Checksum.of(bytes, length - 2));
    return bytes;
  }

  /**
   * Returns the answer to this packet: the same id and sequence number, the opposite direction, and
   * a kind that is higher by one. Measured: all pairs in published logs.
   */
  Packet answer(byte[] newPayload) {
    int number = (kind >> KIND_SHIFT) + 1 & KIND_MASK;
    int answering = (~kind & DIRECTION) | number << KIND_SHIFT;
    return new Packet(answering, id, sequence, newPayload);
  }

  /** Returns a byte of the payload, unsigned; -1 if the payload is shorter. */
  int unsigned(int index) {
    return index < payload.length ? Byte.toUnsignedInt(payload[index]) : -1;
  }

  /** Returns a 32-bit integer of the payload; -1 if the payload is shorter. */
  int integer(int index) {
    return index + Integer.BYTES <= payload.length
        ? ByteBuffer.wrap(payload).order(ByteOrder.LITTLE_ENDIAN).getInt(index)
        : -1;
  }

  /** Returns a 32-bit floating point number of the payload; empty if the payload is shorter. */
  Optional<Float> number(int index) {
    return index + Float.BYTES <= payload.length
        ? Optional.of(ByteBuffer.wrap(payload).order(ByteOrder.LITTLE_ENDIAN).getFloat(index))
        : Optional.empty();
  }
}
