package tellosimulator.video.codec;

import java.util.Arrays;

/**
 * Writes NAL units in byte stream format (H.264, Annex B), with a start code before each unit and
 * emulation prevention bytes within. The buffer is reused for each access unit.
 */
final class AnnexBWriter implements AccessUnit {

  /** Maximum number of NAL units: SPS, PPS and slice. */
  private static final int MAX_NAL_UNITS = 3;

  private static final int START_CODE_LENGTH = 4;

  private final int[] starts = new int[MAX_NAL_UNITS + 1];
  private byte[] bytes = new byte[1 << 17];
  private int nalUnits;
  private boolean idr;

  /** Begins an access unit and discards the previous one. */
  void begin(boolean newIdr) {
    nalUnits = 0;
    idr = newIdr;
  }

  /**
   * Appends a NAL unit.
   *
   * @param header nal_ref_idc and nal_unit_type
   * @param rbsp the payload, which ends with a byte that is not zero
   * @param length the length of the payload [bytes]
   */
  void add(int header, byte[] rbsp, int length) {
    int at = starts[nalUnits];
    reserve(at, START_CODE_LENGTH + 1 + length + length / 2);
    bytes[at] = 0;
    bytes[at + 1] = 0;
    bytes[at + 2] = 0;
    bytes[at + 3] = 1;
    bytes[at + 4] = (byte) header;
    nalUnits++;
    starts[nalUnits] = writeEscaped(rbsp, length, at + START_CODE_LENGTH + 1);
  }

  private void reserve(int at, int more) {
    if (at + more > bytes.length) {
      bytes = Arrays.copyOf(bytes, 2 * (at + more));
    }
  }

  /**
   * Writes a payload, and inserts an emulation_prevention_three_byte (H.264, 7.4.1) before each
   * byte below 4 that follows two zeros. Returns the end offset.
   */
  private int writeEscaped(byte[] rbsp, int length, int start) {
    int to = start;
    int zeros = 0;
    for (int from = 0; from < length; from++) {
      byte next = rbsp[from];
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
    return starts[nalUnits];
  }

  @Override
  public int nalUnits() {
    return nalUnits;
  }

  @Override
  public int start(int index) {
    return starts[index];
  }

  @Override
  public boolean idr() {
    return idr;
  }
}
