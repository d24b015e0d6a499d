package tellosimulator.video;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import tellosimulator.video.codec.AccessUnit;

/**
 * An encoded picture with NAL units of given lengths. The value of each byte is its index within
 * the unit.
 */
final class FakePicture implements AccessUnit {

  private final byte[] bytes;
  private final List<Integer> starts;

  private FakePicture(byte[] bytes, List<Integer> starts) {
    this.bytes = bytes;
    this.starts = List.copyOf(starts);
  }

  static FakePicture of(int... lengths) {
    List<Integer> starts = new ArrayList<>(List.of(0));
    for (int length : lengths) {
      starts.add(starts.get(starts.size() - 1) + length);
    }
    byte[] bytes = new byte[starts.get(starts.size() - 1) + 7]; // longer than the used part
    for (int unit = 0; unit < lengths.length; unit++) {
      for (int i = 0; i < lengths[unit]; i++) {
        bytes[starts.get(unit) + i] = (byte) (i % 251);
      }
    }
    return new FakePicture(bytes, starts);
  }

  static FakePicture of(byte[]... nalUnits) {
    FakePicture picture = of(Stream.of(nalUnits).mapToInt(unit -> unit.length).toArray());
    for (int unit = 0; unit < nalUnits.length; unit++) {
      System.arraycopy(
          nalUnits[unit], 0, picture.bytes, picture.start(unit), nalUnits[unit].length);
    }
    return picture;
  }

  @Override
  public byte[] bytes() {
    return bytes;
  }

  @Override
  public int size() {
    return starts.get(starts.size() - 1);
  }

  @Override
  public int nalUnits() {
    return starts.size() - 1;
  }

  @Override
  public int start(int unit) {
    return starts.get(unit);
  }

  @Override
  public boolean idr() {
    return nalUnits() == 3;
  }
}
