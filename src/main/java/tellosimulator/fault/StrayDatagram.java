package tellosimulator.fault;

/**
 * Creates the binary datagrams that a real drone sends to the command socket in SDK mode. They
 * belong to the app's protocol, and contain information on Wi-Fi, light and flight. Measured:
 * tellopilots.com 4805, DJITelloPy issue 164. The layout and the checksums are from TelloPy 0.7.0.
 */
public final class StrayDatagram {

  /** Polynomial of the CRC-8 over the header: 0x31, reflected. */
  private static final int POLYNOMIAL_8 = 0x8c;

  private static final int START_8 = 0x77;

  /** Polynomial of the CRC-16 over the whole datagram: 0x1021, reflected. */
  private static final int POLYNOMIAL_16 = 0x8408;

  private static final int START_16 = 0x3692;

  private static final int BYTE = 0xff;

  /** Length of the header and the checksums [bytes]. */
  private static final int FRAME = 11;

  private static final char MARK = 0xcc;

  /** Packet type: information from the drone. */
  private static final char KIND = 0x88;

  private StrayDatagram() {}

  /**
   * Returns a datagram of one of three kinds, which take turns: 12 bytes on light, 13 bytes on
   * Wi-Fi, and 35 bytes on flight.
   *
   * @param number the sequence number of the datagram, from 0
   * @return the datagram, one character per byte (ISO-8859-1)
   */
  public static String of(int number) {
    return switch (number % 3) {
      case 0 -> framed(0x35, number, "\u0001");
      case 1 -> framed(0x1a, number, "Z\0");
      default -> framed(0x56, number, "\0".repeat(12) + "B" + "\0".repeat(11));
    };
  }

  /**
   * Puts a message into a frame.
   *
   * @param data one character per byte (ISO-8859-1)
   */
  static String framed(int id, int sequence, String data) {
    int length = FRAME + data.length();
    StringBuilder frame = new StringBuilder().append(MARK);
    appendShort(frame, length << 3);
    frame.append((char) crc(frame, START_8, POLYNOMIAL_8)).append(KIND);
    appendShort(frame, id);
    appendShort(frame, sequence);
    frame.append(data);
    appendShort(frame, crc(frame, START_16, POLYNOMIAL_16));
    return frame.toString();
  }

  /** Appends a 16-bit number in little-endian order. */
  private static void appendShort(StringBuilder frame, int value) {
    frame.append((char) (value & BYTE)).append((char) (value >> 8 & BYTE));
  }

  private static int crc(CharSequence bytes, int start, int polynomial) {
    int crc = start;
    for (int i = 0; i < bytes.length(); i++) {
      crc ^= bytes.charAt(i);
      for (int bit = 0; bit < 8; bit++) {
        crc = (crc & 1) == 1 ? crc >> 1 ^ polynomial : crc >> 1;
      }
    }
    return crc;
  }
}
