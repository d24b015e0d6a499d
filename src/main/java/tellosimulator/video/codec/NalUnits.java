package tellosimulator.video.codec;

import java.util.Arrays;

/**
 * An encoded picture that is filled anew with each picture. Puts a start code before each unit, and
 * a 3 between two zeros and a byte below 4, so that no start code appears where none is meant.
 */
final class NalUnits implements EncodedPicture {

  /** Sequence parameters, picture parameters, slice. */
  private static final int MOST_UNITS = 3;

  private static final int START_CODE_LENGTH = 4;

  private final int[] starts = new int[MOST_UNITS + 1];
  private byte[] bytes = new byte[1 << 17];
  private int units;
  private boolean key;

  /** Forgets the last picture. */
  void begin(boolean keyPicture) {
    units = 0;
    key = keyPicture;
  }

  /**
   * Adds a unit.
   *
   * @param header its first byte
   * @param payload what follows; a byte that is not zero ends it
   * @param length of the payload
   */
  void add(int header, byte[] payload, int length) {
    int at = starts[units];
    reserve(at, START_CODE_LENGTH + 1 + length + length / 2);
    bytes[at] = 0;
    bytes[at + 1] = 0;
    bytes[at + 2] = 0;
    bytes[at + 3] = 1;
    bytes[at + 4] = (byte) header;
    units++;
    starts[units] = escape(payload, length, at + START_CODE_LENGTH + 1);
  }

  private void reserve(int at, int more) {
    if (at + more > bytes.length) {
      bytes = Arrays.copyOf(bytes, 2 * (at + more));
    }
  }

  private int escape(byte[] payload, int length, int start) {
    int to = start;
    int zeros = 0;
    for (int from = 0; from < length; from++) {
      byte next = payload[from];
      if (zeros >= 2 && (next & 0xFC) == 0) {
        bytes[to++] = 3;
        zeros = 0;
      }
      zeros = next == 0 ? zeros + 1 : 0;
      bytes[to++] = next;
    }
    return to;
  }

  @Override
  public byte[] bytes() {
    return bytes;
  }

  @Override
  public int size() {
    return starts[units];
  }

  @Override
  public int units() {
    return units;
  }

  @Override
  public int start(int unit) {
    return starts[unit];
  }

  @Override
  public boolean key() {
    return key;
  }
}
