package tellosimulator.video.codec;

import java.nio.ByteBuffer;
import org.jcodec.codecs.h264.io.model.PictureParameterSet;
import org.jcodec.codecs.h264.io.model.SeqParameterSet;
import org.jcodec.common.model.ColorSpace;

/**
 * What decoders must know before the first picture, written by JCodec: Constrained Baseline, level
 * 4.0, one reference frame, pictures in the order in which they are shown, no timing; the real
 * drone's stream says the same except for its profile.
 */
final class ParameterSets {

  /** Documented: H.264, A.2.1. */
  private static final int BASELINE = 66;

  /** Documented: H.264, A.3; as the real drone says. */
  private static final int LEVEL_4_0 = 40;

  /** Bits of a picture's number; as the real drone has it. */
  static final int FRAME_NUM_BITS = 8;

  /** The quality from which a slice's is told; as the real drone says. */
  static final int FIRST_QP = 26;

  /** Documented: H.264, 7.3.2; of the longest of both. */
  private static final int CAPACITY = 64;

  final byte[] sequence;
  final byte[] picture;

  /**
   * @param width of the picture in pixels, even
   * @param height of the picture in pixels, even
   */
  ParameterSets(int width, int height) {
    ByteBuffer buffer = ByteBuffer.allocate(CAPACITY);
    sequence(width, height).write(buffer);
    sequence = written(buffer);
    picture().write(buffer.clear());
    picture = written(buffer);
  }

  private static SeqParameterSet sequence(int width, int height) {
    SeqParameterSet set = new SeqParameterSet();
    set.profileIdc = BASELINE;
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

  private static PictureParameterSet picture() {
    PictureParameterSet set = new PictureParameterSet();
    set.picInitQpMinus26 = FIRST_QP - 26;
    set.deblockingFilterControlPresentFlag = true;
    return set;
  }

  private static byte[] written(ByteBuffer buffer) {
    byte[] bytes = new byte[buffer.position()];
    buffer.flip().get(bytes);
    return bytes;
  }
}
