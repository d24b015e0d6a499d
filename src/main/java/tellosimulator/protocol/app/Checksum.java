package tellosimulator.protocol.app;

/**
 * The two checksums of the app's protocol. Measured: TelloPy and SMerrony/tello have the
 * polynomials and start values; a radio capture of a real drone agrees in 39 packets.
 */
final class Checksum {

  /** Polynomial of the CRC-8 over the first three bytes: 0x31, reflected. */
  private static final int POLYNOMIAL_8 = 0x8c;

  private static final int START_8 = 0x77;

  /** Polynomial of the CRC-16 over the packet: 0x1021, reflected. */
  private static final int POLYNOMIAL_16 = 0x8408;

  private static final int START_16 = 0x3692;

  /** Number of bytes over which the CRC-8 goes. */
  private static final int HEADER = 3;

  private Checksum() {}

  /** Returns the CRC-8 over the first three bytes. */
  static int ofHeader(byte[] bytes) {
    return crc(bytes, HEADER, START_8, POLYNOMIAL_8);
  }

  /** Returns the CRC-16 over the first bytes. */
  static int of(byte[] bytes, int length) {
    return crc(bytes, length, START_16, POLYNOMIAL_16);
  }

  private static int crc(byte[] bytes, int length, int start, int polynomial) {
    int crc = start;
    for (int i = 0; i < length; i++) {
      crc ^= Byte.toUnsignedInt(bytes[i]);
      for (int bit = 0; bit < Byte.SIZE; bit++) {
        crc = (crc & 1) == 1 ? crc >> 1 ^ polynomial : crc >> 1;
      }
    }
    return crc;
  }
}
