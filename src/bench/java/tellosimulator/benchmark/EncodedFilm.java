package tellosimulator.benchmark;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.jcodec.codecs.h264.encode.RateControl;
import org.jcodec.codecs.h264.io.model.SliceType;
import org.jcodec.common.model.ColorSpace;
import org.jcodec.common.model.Size;
import tellosimulator.video.codec.AccessUnit;
import tellosimulator.video.codec.H264Encoder;
import tellosimulator.video.picture.Picture;

/** A part of the flight as one encoder made it: H.264, Annex B. */
final class EncodedFilm {

  /** Documented: what the drone sends at first, and how often one can begin to decode. */
  static final int BITS_PER_SECOND = 2_500_000;

  static final int PICTURES_PER_SECOND = 30;

  /** JCodec's samples are 128 less. */
  private static final int JCODECS_OFFSET = 128;

  private final byte[] stream;
  private final int pictures;
  private final List<Double> times;

  /**
   * @param pictures how many there are
   * @param times how long each took [ms]
   */
  EncodedFilm(byte[] stream, int pictures, List<Double> times) {
    this.stream = stream;
    this.pictures = pictures;
    this.times = List.copyOf(times);
  }

  /** By the project's encoder. */
  static EncodedFilm ours(List<Picture> pictures) {
    H264Encoder encoder = new H264Encoder(pictures.get(0).width(), pictures.get(0).height());
    encoder.setRate(PICTURES_PER_SECOND, BITS_PER_SECOND);
    ByteArrayOutputStream stream = new ByteArrayOutputStream();
    List<Double> times = new ArrayList<>();
    for (int i = 0; i < pictures.size(); i++) {
      Picture picture = pictures.get(i);
      boolean key = i % PICTURES_PER_SECOND == 0;
      AccessUnit[] encoded = new AccessUnit[1];
      times.add(Stopwatch.ms(() -> encoded[0] = encoder.encode(picture, key)));
      stream.write(encoded[0].bytes(), 0, encoded[0].size());
    }
    return new EncodedFilm(stream.toByteArray(), pictures.size(), times);
  }

  /**
   * By JCodec's encoder as it comes, but for a QP that follows the bit rate as far as it can: it
   * skips nothing, and 2700 macroblocks of a picture that does not change take 13.5 kB, which are
   * 3.2 Mbit/s.
   */
  static EncodedFilm jcodecs(List<Picture> pictures) {
    int width = pictures.get(0).width();
    int height = pictures.get(0).height();
    org.jcodec.codecs.h264.H264Encoder encoder =
        new org.jcodec.codecs.h264.H264Encoder(new FollowingRate());
    encoder.setKeyInterval(PICTURES_PER_SECOND);
    ByteBuffer buffer = ByteBuffer.allocate(4 * width * height);
    ByteArrayOutputStream stream = new ByteArrayOutputStream();
    List<Double> times = new ArrayList<>();
    for (Picture picture : pictures) {
      org.jcodec.common.model.Picture theirs =
          org.jcodec.common.model.Picture.createPicture(
              width, height, planes(picture), ColorSpace.YUV420J);
      ByteBuffer[] encoded = new ByteBuffer[1];
      times.add(
          Stopwatch.ms(() -> encoded[0] = encoder.encodeFrame(theirs, buffer.clear()).getData()));
      byte[] bytes = new byte[encoded[0].remaining()];
      encoded[0].get(bytes);
      stream.writeBytes(bytes);
    }
    return new EncodedFilm(stream.toByteArray(), pictures.size(), times);
  }

  private static byte[][] planes(Picture picture) {
    byte[][] planes = {picture.y().clone(), picture.u().clone(), picture.v().clone()};
    for (byte[] plane : planes) {
      for (int i = 0; i < plane.length; i++) {
        plane[i] = (byte) ((plane[i] & 0xFF) - JCODECS_OFFSET);
      }
    }
    return planes;
  }

  /** The stream itself, not a copy. */
  byte[] stream() {
    return stream;
  }

  /** How long each picture took [ms]. */
  List<Double> times() {
    return times;
  }

  double megabitsPerSecond() {
    return stream.length * 8e-6 * PICTURES_PER_SECOND / pictures;
  }

  /** Raises QP while more was sent than may be, and lowers it while less. */
  private static final class FollowingRate implements RateControl {

    private static final int FIRST_QP = 36;
    private static final int SHARE = BITS_PER_SECOND / PICTURES_PER_SECOND;

    /** A key picture may take so many pictures' share before QP rises. */
    private static final int PATIENCE = 5;

    private int qp = FIRST_QP;
    private int pictureBits;
    private int owed;

    @Override
    public int startPicture(Size size, int most, SliceType type) {
      owed = Math.max(-PATIENCE * SHARE, owed + pictureBits - SHARE);
      pictureBits = 0;
      if (owed > PATIENCE * SHARE) {
        qp = Math.min(48, qp + 2);
      } else if (owed < 0) {
        qp = Math.max(12, qp - 1);
      }
      return qp;
    }

    @Override
    public int initialQpDelta() {
      return 0;
    }

    @Override
    public int accept(int bits) {
      pictureBits += bits;
      return 0;
    }
  }
}
