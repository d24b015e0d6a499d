package tellosimulator.video;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.jcodec.codecs.h264.io.model.SeqParameterSet;
import tellosimulator.command.Packetizer;
import tellosimulator.video.codec.AccessUnit;
import tellosimulator.video.picture.Picture;

/**
 * Reassembles a drone's pictures from the datagrams of its stream without decoding them. Each NAL
 * unit begins with a new datagram, and ends with a datagram that is shorter than the others, or
 * that the header of the app's protocol marks as the last. If datagrams are lost, the rest of the
 * slice is passed on, just as decoders receive it. Not thread-safe.
 */
public final class ReceivedStream {

  private static final int START_CODE_LENGTH = 4;

  /** Length of the header that the app's protocol puts in front of each datagram [bytes]. */
  private static final int NUMBERS = 2;

  /** The bit in the second byte of that header that marks the last datagram of a NAL unit. */
  private static final int LAST = 0x80;

  /**
   * Maximum size of a NAL unit [bytes]; anything larger is not video. Decided: the data of one
   * second at 16 Mbit/s.
   */
  private static final int LARGEST = 2_000_000;

  /**
   * Maximum width or height of a picture [pixels]. Decided: about twice the width of the drone's
   * pictures.
   */
  private static final int MOST_PIXELS = 2048;

  /**
   * Type of a NAL unit that contains a slice, except for slices of IDR pictures. Documented, like
   * the types below: H.264, table 7-1.
   */
  private static final int SLICE = 1;

  private static final int IDR_SLICE = 5;
  private static final int SPS = 7;
  private static final int PPS = 8;

  private final Consumer<FilmedPicture> pictures;
  private final ByteArrayOutputStream unit = new ByteArrayOutputStream();
  private long begun;
  private int header;
  private Optional<byte[]> sps = Optional.empty();
  private Optional<byte[]> pps = Optional.empty();

  /** A blank picture with the size given in the sequence parameter set. */
  private Optional<Picture> canvas = Optional.empty();

  /**
   * Creates a stream that has not received anything yet.
   *
   * @param pictures receives complete pictures, starting with an IDR picture
   */
  public ReceivedStream(Consumer<FilmedPicture> pictures) {
    this.pictures = pictures;
  }

  /**
   * Processes the next datagram.
   *
   * @param nanos time of arrival, on any clock [ns]
   */
  public void take(byte[] datagram, long nanos) {
    boolean plain = startsUnit(datagram, 0);
    boolean numbered = startsUnit(datagram, NUMBERS);
    if (plain || numbered) {
      finish();
      begun = nanos;
      header = numbered ? NUMBERS : 0;
    } else if (unit.size() == 0 || datagram.length < header) {
      return;
    }
    unit.write(datagram, header, datagram.length - header);
    boolean last = header == 0 ? datagram.length < Packetizer.FULL : (datagram[1] & LAST) != 0;
    if (last || unit.size() > LARGEST) {
      finish();
    }
  }

  private static boolean startsUnit(byte[] datagram, int at) {
    return datagram.length > at + START_CODE_LENGTH
        && datagram[at] == 0
        && datagram[at + 1] == 0
        && datagram[at + 2] == 0
        && datagram[at + 3] == 1;
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
        // not needed for a recording
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

  /**
   * Returns a picture with the size given in a sequence parameter set; empty if the set is damaged.
   */
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
    } catch (RuntimeException e) { // JCodec read beyond the end of the set
      return Optional.empty();
    }
  }

  private void film(boolean idr, List<byte[]> units) {
    if (canvas.isPresent()) {
      Optional<AccessUnit> encoded = Optional.of(new ReceivedUnit(idr, units));
      pictures.accept(new FilmedPicture(canvas.get(), encoded, VideoFigures.NONE, begun));
    }
  }

  /** The NAL units as received, each with its start code. */
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
