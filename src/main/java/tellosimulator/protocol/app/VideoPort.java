package tellosimulator.protocol.app;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.OptionalInt;
import tellosimulator.command.WireText;

/** The port for the video in a request to connect, and in its acknowledgement. */
public final class VideoPort {

  private static final int AT = NamedPacket.REQUEST.length();
  private static final int LENGTH = AT + Short.BYTES;

  private VideoPort() {}

  /** Returns the port in a datagram; empty if it is neither a request nor an acknowledgement. */
  public static OptionalInt of(byte[] datagram) {
    String text = WireText.decode(datagram);
    boolean connects =
        text.startsWith(NamedPacket.REQUEST) || text.startsWith(NamedPacket.ACKNOWLEDGEMENT);
    return connects && datagram.length == LENGTH
        ? OptionalInt.of(Short.toUnsignedInt(littleEndian(datagram).getShort(AT)))
        : OptionalInt.empty();
  }

  /** Returns a copy of a request or an acknowledgement with another port. */
  public static byte[] replaced(byte[] datagram, int port) {
    byte[] copy = Arrays.copyOf(datagram, datagram.length);
    littleEndian(copy).putShort(AT, (short) port);
    return copy;
  }

  /** Returns the acknowledgement of a request with a port. */
  static byte[] acknowledgement(int port) {
    return replaced(WireText.encode(NamedPacket.ACKNOWLEDGEMENT + "\0\0"), port);
  }

  private static ByteBuffer littleEndian(byte[] bytes) {
    return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }
}
