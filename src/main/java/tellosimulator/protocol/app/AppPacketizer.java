package tellosimulator.protocol.app;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import tellosimulator.command.Packetizer;

/**
 * Splits the video for the app: two bytes in front of each datagram are the number of the NAL unit
 * and the index of the datagram within the unit, whose last one has the highest bit set. Measured:
 * a radio capture (m6c7l/dji-ryze-tello). Confined to the video thread.
 */
final class AppPacketizer implements Packetizer {

  /** Bytes of video in a datagram. */
  private static final int FULL = Packetizer.FULL - 2;

  private static final int LAST = 0x80;

  /** First byte of a NAL unit with a picture after its start code is at this index. */
  private static final int UNIT_TYPE = 4;

  private static final int TYPE_MASK = 0x1f;

  /** Highest type of a NAL unit that holds a picture. Documented: ITU-T H.264, table 7-1. */
  private static final int PICTURES = 5;

  private int number;

  @Override
  public List<byte[]> packets(ByteBuffer nalUnit) {
    List<byte[]> packets = new ArrayList<>();
    boolean picture = (nalUnit.get(nalUnit.position() + UNIT_TYPE) & TYPE_MASK) <= PICTURES;
    // Some clients wait for a datagram that is not the last one of its unit.
    int most = picture && nalUnit.remaining() <= FULL ? nalUnit.remaining() - 1 : FULL;
    while (nalUnit.hasRemaining()) {
      int length = Math.min(most, nalUnit.remaining());
      byte[] packet = new byte[length + 2];
      nalUnit.get(packet, 2, length);
      packet[0] = (byte) number;
      packet[1] = (byte) (packets.size() | (nalUnit.hasRemaining() ? 0 : LAST));
      packets.add(packet);
    }
    number++;
    return packets;
  }
}
