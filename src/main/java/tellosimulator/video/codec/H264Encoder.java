package tellosimulator.video.codec;

import tellosimulator.video.picture.Picture;

/**
 * An H.264 encoder for the Constrained Baseline profile, with one slice per frame and one reference
 * frame. A GOP consists of an IDR frame and the P frames up to the next IDR frame; there are no B
 * frames and no deblocking.
 *
 * <p>JCodec's own encoder compares sample by sample in its motion search, never codes P_Skip, and
 * allocates arrays throughout. This encoder takes only the parameter sets and VLC tables from
 * JCodec. It reuses its arrays, and processes eight samples at once ({@link Swar}). After the first
 * frames, it allocates memory only when a QP is used for the first time.
 */
public final class H264Encoder implements VideoEncoder {

  /**
   * The header byte of the NAL unit of an SPS. Each header consists of nal_ref_idc and
   * nal_unit_type. Documented: H.264, 7.3.1.
   */
  private static final int NAL_SPS = 0x67;

  /** The header byte of the NAL unit of a PPS. */
  private static final int NAL_PPS = 0x68;

  /** The header byte of the NAL unit of an IDR slice. */
  private static final int NAL_IDR_SLICE = 0x65;

  /** The header byte of the NAL unit of any other slice. */
  private static final int NAL_NON_IDR_SLICE = 0x41;

  /** Number of different values of idr_pic_id. Documented: H.264, 7.4.3. */
  private static final int IDR_PIC_IDS = 1 << 16;

  private final int width;
  private final int height;
  private final ParameterSets parameterSets;
  private final Frame source;
  private final MacroblockWriter writer;
  private final SliceEncoder slices;
  private final RateControl rateControl;
  private final AnnexBWriter accessUnit = new AnnexBWriter();
  private final QpTables[] qpTables = new QpTables[QpTables.MAX_QP + 1];
  private boolean started;
  private int frameNum;
  private int idrPicId;

  /**
   * Creates an encoder.
   *
   * @param width width of the frames [pixels], even
   * @param height height of the frames [pixels], even
   */
  public H264Encoder(int width, int height) {
    this.width = width;
    this.height = height;
    parameterSets = new ParameterSets(width, height);
    source = new Frame((width + 15) / 16, (height + 15) / 16);
    writer = new MacroblockWriter(source.widthInMbs, source.heightInMbs);
    slices = new SliceEncoder(source, writer);
    rateControl = new RateControl(source.widthInMbs * source.heightInMbs, source.heightInMbs);
  }

  @Override
  public void setRate(int framesPerSecond, int bitsPerSecond) {
    rateControl.setRate(framesPerSecond, bitsPerSecond);
  }

  @Override
  public AccessUnit encode(Picture picture, boolean forceIdr) {
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
    boolean idr = forceIdr || !started;
    started = true;
    source.load(picture);
    accessUnit.begin(idr);
    if (idr) {
      frameNum = 0;
      accessUnit.add(NAL_SPS, parameterSets.sps, parameterSets.sps.length);
      accessUnit.add(NAL_PPS, parameterSets.pps, parameterSets.pps.length);
    }
    encodeSlice(idr);
    return accessUnit;
  }

  /** The reconstruction of the last frame, for tests. */
  Frame reconstruction() {
    return slices.reconstruction();
  }

  private QpTables tables(int qp) {
    if (qpTables[qp] == null) {
      qpTables[qp] = QpTables.of(qp);
    }
    return qpTables[qp];
  }

  private void encodeSlice(boolean idr) {
    int qp = rateControl.beginFrame(idr);
    writer.beginSlice(idr, frameNum, idrPicId, qp);
    slices.beginFrame();
    for (int mbY = 0; mbY < source.heightInMbs; mbY++) {
      slices.encodeRow(mbY, idr, tables(qp));
      qp = rateControl.rowCoded(mbY + 1, writer.bitCount());
    }
    slices.reconstruction().expandBorders();
    BitWriter rbsp = writer.finishSlice();
    accessUnit.add(idr ? NAL_IDR_SLICE : NAL_NON_IDR_SLICE, rbsp.bytes(), rbsp.size());
    rateControl.endFrame(8 * rbsp.size());
    frameNum = (frameNum + 1) % (1 << ParameterSets.FRAME_NUM_BITS);
    if (idr) {
      idrPicId = (idrPicId + 1) % IDR_PIC_IDS;
    }
  }
}
