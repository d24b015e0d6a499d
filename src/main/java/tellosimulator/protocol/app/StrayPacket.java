package tellosimulator.protocol.app;

/**
 * Creates the packets that a real drone sends to the command socket in SDK mode, although they
 * belong to the app's protocol: on light, on Wi-Fi, and on flight. Measured: tellopilots.com 4805,
 * DJITelloPy issue 164.
 */
public final class StrayPacket {

  /** Where flight data have the battery, which is at 66 % in a radio capture. */
  private static final int BATTERY_AT = 12;

  private static final byte BATTERY = 66;

  private StrayPacket() {}

  /**
   * Returns a datagram of one of three kinds, which take turns: 12, 13 and 35 bytes.
   *
   * @param number the sequence number of the packet, from 0
   */
  public static byte[] of(int number) {
    return switch (number % 3) {
      case 0 -> packet(MessageId.LIGHT, number, Telemetry.light());
      case 1 -> packet(MessageId.WIFI, number, Telemetry.wifi());
      default -> {
        byte[] flight = new byte[Telemetry.FLIGHT_LENGTH];
        flight[BATTERY_AT] = BATTERY;
        yield packet(MessageId.FLIGHT_DATA, number, flight);
      }
    };
  }

  private static byte[] packet(MessageId id, int number, byte[] payload) {
    return new Packet(Packet.NOTIFICATION, id.number(), number & 0xffff, payload).bytes();
  }
}
