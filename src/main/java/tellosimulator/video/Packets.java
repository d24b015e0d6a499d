package tellosimulator.video;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import tellosimulator.video.codec.AccessUnit;

/**
 * Cuts encoded pictures into datagrams as the drone does: each NAL unit begins a new one, and its
 * last is shorter than the others, by which clients know that it is whole.
 */
final class Packets {

  /** Bytes of all but the last datagram of a NAL unit. Documented: Tello-Python; measured. */
  static final int FULL = 1460;

  private Packets() {}

  /** The datagrams of a picture, in their order. */
  static List<byte[]> of(AccessUnit picture) {
    List<byte[]> packets = new ArrayList<>();
    for (int unit = 0; unit < picture.nalUnits(); unit++) {
      int end = picture.start(unit + 1);
      int from = picture.start(unit);
      while (end - from >= FULL) {
        packets.add(Arrays.copyOfRange(picture.bytes(), from, from + FULL));
        from += FULL;
      }
      packets.add(last(picture.bytes(), from, end));
    }
    return packets;
  }

  /** Where nothing is left, a zero byte, which a stream may have after each NAL unit. */
  private static byte[] last(byte[] bytes, int from, int end) {
    return from == end ? new byte[1] : Arrays.copyOfRange(bytes, from, end);
  }
}
