package tellosimulator.video.codec;

import java.nio.ByteBuffer;
import org.jcodec.codecs.h264.io.model.PictureParameterSet;
import org.jcodec.codecs.h264.io.model.SeqParameterSet;
import org.jcodec.common.model.ColorSpace;

/**
 * SPS and PPS, written by JCodec. They specify Constrained Baseline, level 4.0, one reference
 * frame, the same order for output and decoding, and no VUI. The parameter sets of the real drone
 * differ only in the profile.
 */
final class ParameterSets {

  /** The profile_idc. Documented: H.264, A.2.1. */
  private static final int BASELINE_PROFILE = 66;

  /** The level_idc. Documented: H.264, A.3. The real drone uses the same value. */
  private static final int LEVEL_4_0 = 40;

  /** Number of bits of frame_num. The real drone uses the same value. */
  static final int FRAME_NUM_BITS = 8;

  /** The QP to which slice_qp_delta is relative. The real drone uses the same value. */
  static final int PIC_INIT_QP = 26;

  /**
   * Size of the buffer for one parameter set [bytes]. Decided: more than the longer set takes
   * (H.264, 7.3.2).
   */
  private static final int CAPACITY = 64;

  final byte[] sps;
  final byte[] pps;

  /**
   * Creates the parameter sets.
   *
   * @param width width of the frames [pixels], even
   * @param height height of the frames [pixels], even
   */
  ParameterSets(int width, int height) {
    ByteBuffer buffer = ByteBuffer.allocate(CAPACITY);
    sps(width, height).write(buffer);
    sps = written(buffer);
    pps().write(buffer.clear());
    pps = written(buffer);
  }

  private static SeqParameterSet sps(int width, int height) {
    SeqParameterSet set = new SeqParameterSet();
    set.profileIdc = BASELINE_PROFILE;
    set.constraintSet0Flag = true;
    set.constraintSet1Flag = true;
    set.levelIdc = LEVEL_4_0;
    set.chromaFormatIdc = ColorSpace.YUV420;
    set.log2MaxFrameNumMinus4 = FRAME_NUM_BITS - 4;
    set.picOrderCntType = 2;
    set.numRefFrames = 1;
    set.frameMbsOnlyFlag = true;
    set.direct8x8InferenceFlag = true;
    set.picWidthInMbsMinus1 = (width + 15) / 16 - 1;
    set.picHeightInMapUnitsMinus1 = (height + 15) / 16 - 1;
    set.frameCroppingFlag = width % 16 != 0 || height % 16 != 0;
    set.frameCropRightOffset = (-width & 15) / 2;
    set.frameCropBottomOffset = (-height & 15) / 2;
    return set;
  }

  private static PictureParameterSet pps() {
    PictureParameterSet set = new PictureParameterSet();
    set.picInitQpMinus26 = PIC_INIT_QP - 26;
    set.deblockingFilterControlPresentFlag = true;
    return set;
  }

  private static byte[] written(ByteBuffer buffer) {
    byte[] bytes = new byte[buffer.position()];
    buffer.flip().get(bytes);
    return bytes;
  }
}
