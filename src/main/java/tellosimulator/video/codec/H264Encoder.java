package tellosimulator.video.codec;

import tellosimulator.video.picture.Picture;

/**
 * An H.264 encoder for pictures of one size: Constrained Baseline, one slice a picture, each
 * picture predicted from the one before or, if it is a key picture, from nothing.
 *
 * <p>JCodec's own encoder searches motion by comparing pixel by pixel, never skips a macroblock and
 * makes arrays all the time. This one takes JCodec's parameter sets and code tables, and does the
 * rest on arrays that it keeps, eight pixels at once. After the first pictures it allocates nothing
 * but tables when a quality is first used.
 */
public final class H264Encoder implements VideoEncoder {

  /** Documented: H.264, 7.3.1: the first byte of a unit that others refer to. */
  private static final int SEQUENCE = 0x67;

  private static final int PICTURE = 0x68;
  private static final int KEY_SLICE = 0x65;
  private static final int SLICE = 0x41;

  /** Documented: H.264, 7.4.3: the number of a key picture is below. */
  private static final int KEY_NUMBERS = 1 << 16;

  private final int width;
  private final int height;
  private final ParameterSets parameters;
  private final Frame source;
  private final MacroblockWriter writer;
  private final PictureCoder coder;
  private final RateControl rate;
  private final NalUnits units = new NalUnits();
  private final Quality[] qualities = new Quality[Quality.COARSEST + 1];
  private boolean started;
  private int number;
  private int keyNumber;

  /**
   * @param width of the pictures in pixels, even
   * @param height of the pictures in pixels, even
   */
  public H264Encoder(int width, int height) {
    this.width = width;
    this.height = height;
    parameters = new ParameterSets(width, height);
    source = new Frame((width + 15) / 16, (height + 15) / 16);
    writer = new MacroblockWriter(source.columns, source.rows);
    coder = new PictureCoder(source, writer);
    rate = new RateControl(source.columns * source.rows, source.rows);
  }

  @Override
  public void setRate(int framesPerSecond, int bitsPerSecond) {
    rate.setRate(framesPerSecond, bitsPerSecond);
  }

  @Override
  public EncodedPicture encode(Picture picture, boolean key) {
    if (picture.width() != width || picture.height() != height) {
      throw new IllegalArgumentException(
          "picture is "
              + picture.width()
              + " by "
              + picture.height()
              + ", but the encoder's are "
              + width
              + " by "
              + height);
    }
    boolean begin = key || !started;
    started = true;
    source.load(picture);
    units.begin(begin);
    if (begin) {
      number = 0;
      units.add(SEQUENCE, parameters.sequence, parameters.sequence.length);
      units.add(PICTURE, parameters.picture, parameters.picture.length);
    }
    slice(begin);
    return units;
  }

  /** The last picture as decoders see it, for tests. */
  Frame coded() {
    return coder.coded();
  }

  private Quality quality(int qp) {
    if (qualities[qp] == null) {
      qualities[qp] = Quality.of(qp);
    }
    return qualities[qp];
  }

  private void slice(boolean key) {
    int qp = rate.begin(key);
    writer.begin(key, number, keyNumber, qp);
    coder.next();
    for (int row = 0; row < source.rows; row++) {
      coder.row(row, key, quality(qp));
      qp = rate.row(row + 1, writer.bits());
    }
    coder.coded().extend();
    BitWriter bits = writer.finish();
    units.add(key ? KEY_SLICE : SLICE, bits.bytes(), bits.size());
    rate.end(8 * bits.size());
    number = (number + 1) % (1 << ParameterSets.FRAME_NUM_BITS);
    if (key) {
      keyNumber = (keyNumber + 1) % KEY_NUMBERS;
    }
  }
}
