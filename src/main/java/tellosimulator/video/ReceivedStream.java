package tellosimulator.video;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.jcodec.codecs.h264.io.model.SeqParameterSet;
import tellosimulator.video.codec.AccessUnit;
import tellosimulator.video.picture.Picture;

/**
 * Puts a drone's pictures together again from the datagrams of its stream, without decoding them:
 * each NAL unit begins a datagram, and ends with one that is shorter than the others. Where some
 * are lost, what is there of a slice is passed on, as decoders get it. For one thread.
 */
public final class ReceivedStream {

  private static final int START_CODE_LENGTH = 4;

  /** Largest NAL unit; what is larger is no video [bytes]. Decided: a second at 16 Mbit/s. */
  private static final int LARGEST = 2_000_000;

  /** Largest width or height. Decided: twice that of the drone. */
  private static final int MOST_PIXELS = 2048;

  /** Types of NAL units. Documented: H.264, table 7-1. */
  private static final int SLICE = 1;

  private static final int IDR_SLICE = 5;
  private static final int SPS = 7;
  private static final int PPS = 8;

  private final Consumer<FilmedPicture> pictures;
  private final ByteArrayOutputStream unit = new ByteArrayOutputStream();
  private long begun;
  private Optional<byte[]> sps = Optional.empty();
  private Optional<byte[]> pps = Optional.empty();

  /** As large as the sequence parameter set says; what is on it is not known. */
  private Optional<Picture> canvas = Optional.empty();

  /**
   * Has seen nothing yet.
   *
   * @param pictures takes those that are whole, beginning with an IDR picture
   */
  public ReceivedStream(Consumer<FilmedPicture> pictures) {
    this.pictures = pictures;
  }

  /**
   * Takes the next datagram.
   *
   * @param nanos when it came, on any clock [ns]
   */
  public void take(byte[] datagram, long nanos) {
    if (startsUnit(datagram)) {
      finish();
      begun = nanos;
    }
    if (unit.size() > 0 || startsUnit(datagram)) {
      unit.writeBytes(datagram);
    }
    if (datagram.length < Packets.FULL || unit.size() > LARGEST) {
      finish();
    }
  }

  private static boolean startsUnit(byte[] datagram) {
    return datagram.length > START_CODE_LENGTH
        && datagram[0] == 0
        && datagram[1] == 0
        && datagram[2] == 0
        && datagram[3] == 1;
  }

  private void finish() {
    if (unit.size() == 0) {
      return;
    }
    byte[] bytes = unit.toByteArray();
    unit.reset();
    switch (bytes[START_CODE_LENGTH] & 0x1f) {
      case SPS -> adopt(bytes);
      case PPS -> pps = Optional.of(bytes);
      case IDR_SLICE -> {
        if (sps.isPresent() && pps.isPresent()) {
          film(true, List.of(sps.get(), pps.get(), bytes));
        }
      }
      case SLICE -> film(false, List.of(bytes));
      default -> {
        // nothing that a film needs
      }
    }
  }

  private void adopt(byte[] bytes) {
    Optional<Picture> described = described(bytes);
    if (described.isEmpty()) {
      return;
    }
    sps = Optional.of(bytes);
    boolean same =
        canvas.isPresent()
            && canvas.get().width() == described.get().width()
            && canvas.get().height() == described.get().height();
    canvas = same ? canvas : described;
  }

  /** A picture of the size that a sequence parameter set says; empty if that is damaged. */
  private static Optional<Picture> described(byte[] bytes) {
    int header = START_CODE_LENGTH + 1;
    try {
      SeqParameterSet set =
          SeqParameterSet.read(ByteBuffer.wrap(bytes, header, bytes.length - header).slice());
      int width = 16 * (set.picWidthInMbsMinus1 + 1);
      int height = 16 * (set.picHeightInMapUnitsMinus1 + 1);
      if (set.frameCroppingFlag) { // in units of two pixels (H.264, 7.4.2.1.1)
        width -= 2 * (set.frameCropLeftOffset + set.frameCropRightOffset);
        height -= 2 * (set.frameCropTopOffset + set.frameCropBottomOffset);
      }
      return width > 0 && height > 0 && width <= MOST_PIXELS && height <= MOST_PIXELS
          ? Optional.of(new Picture(width, height))
          : Optional.empty();
    } catch (RuntimeException e) { // it reads beyond the end
      return Optional.empty();
    }
  }

  private void film(boolean idr, List<byte[]> units) {
    if (canvas.isPresent()) {
      Optional<AccessUnit> encoded = Optional.of(new ReceivedUnit(idr, units));
      pictures.accept(new FilmedPicture(canvas.get(), encoded, VideoFigures.NONE, begun));
    }
  }

  /** NAL units as they came, each with its start code. */
  private static final class ReceivedUnit implements AccessUnit {

    private final boolean idr;
    private final byte[] bytes;
    private final List<Integer> starts = new ArrayList<>(List.of(0));

    ReceivedUnit(boolean idr, List<byte[]> units) {
      this.idr = idr;
      ByteArrayOutputStream all = new ByteArrayOutputStream();
      for (byte[] each : units) {
        all.writeBytes(each);
        starts.add(all.size());
      }
      bytes = all.toByteArray();
    }

    @Override
    public byte[] bytes() {
      return bytes;
    }

    @Override
    public int size() {
      return bytes.length;
    }

    @Override
    public int nalUnits() {
      return starts.size() - 1;
    }

    @Override
    public int start(int index) {
      return starts.get(index);
    }

    @Override
    public boolean idr() {
      return idr;
    }
  }
}
