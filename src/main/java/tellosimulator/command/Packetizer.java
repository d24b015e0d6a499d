package tellosimulator.command;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;

/**
 * Splits the NAL units of a video stream into datagrams. Called on the video thread, in the order
 * of the stream.
 */
@FunctionalInterface
public interface Packetizer {

  /**
   * Size of all datagrams of a NAL unit except the last one [bytes]. Documented: Tello-Python;
   * confirmed by measurement.
   */
  int FULL = 1460;

  /**
   * The raw stream of the SDK. Each NAL unit begins a new datagram. The last datagram of a NAL unit
   * is shorter than the others; clients recognize by its length that the unit is complete. If no
   * bytes remain for it, it contains a single zero byte, which a stream may contain after any NAL
   * unit.
   */
  Packetizer RAW =
      nalUnit -> {
        List<byte[]> packets = new ArrayList<>();
        while (nalUnit.remaining() >= FULL) {
          byte[] full = new byte[FULL];
          nalUnit.get(full);
          packets.add(full);
        }
        byte[] last = new byte[Math.max(1, nalUnit.remaining())];
        nalUnit.get(last, 0, nalUnit.remaining());
        packets.add(last);
        return packets;
      };

  /** Returns the datagrams of a NAL unit. The unit begins with its start code. */
  List<byte[]> packets(ByteBuffer nalUnit);
}
