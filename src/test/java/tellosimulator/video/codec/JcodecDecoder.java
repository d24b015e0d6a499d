package tellosimulator.video.codec;

import java.nio.ByteBuffer;
import java.util.Arrays;
import org.jcodec.codecs.h264.H264Utils;
import org.jcodec.codecs.h264.H264Utils.MvList2D;
import org.jcodec.codecs.h264.decode.DeblockerInput;
import org.jcodec.codecs.h264.decode.FrameReader;
import org.jcodec.codecs.h264.decode.SliceDecoder;
import org.jcodec.codecs.h264.decode.SliceReader;
import org.jcodec.codecs.h264.io.model.Frame;
import org.jcodec.codecs.h264.io.model.NALUnitType;
import org.jcodec.codecs.h264.io.model.SeqParameterSet;
import org.jcodec.codecs.h264.io.model.SliceHeader;
import org.jcodec.common.IntObjectMap;
import org.jcodec.common.model.ColorSpace;
import org.jcodec.common.model.Rect;

/**
 * JCodec's decoder, which is independent of this project's encoder. Assembled from its parts,
 * because as a whole it applies the deblocking filter even if a slice disables it.
 */
final class JcodecDecoder {

  /** JCodec's samples are lower by 128. */
  private static final int OFFSET = 128;

  private final FrameReader reader = new FrameReader();
  private final Frame[] references = new Frame[1 << ParameterSets.FRAME_NUM_BITS];
  private Frame decoded;

  void decode(AccessUnit accessUnit) {
    ByteBuffer bytes = ByteBuffer.wrap(accessUnit.bytes(), 0, accessUnit.size());
    SliceReader slice = reader.readFrame(H264Utils.splitFrame(bytes)).get(0);
    SliceHeader header = slice.getSliceHeader();
    if (slice.getNALUnit().type == NALUnitType.IDR_SLICE) {
      Arrays.fill(references, null);
    }
    decoded = blank(header);
    new SliceDecoder(
            header.sps,
            references,
            new IntObjectMap<Frame>(),
            new DeblockerInput(header.sps),
            decoded)
        .decodeFromReader(slice);
    Arrays.fill(references, null);
    references[header.frameNum] = decoded;
  }

  private static Frame blank(SliceHeader header) {
    SeqParameterSet set = header.sps;
    int columns = set.picWidthInMbsMinus1 + 1;
    int rows = set.picHeightInMapUnitsMinus1 + 1;
    int pixels = 256 * columns * rows;
    byte[][] planes = {new byte[pixels], new byte[pixels / 4], new byte[pixels / 4]};
    Rect shown =
        new Rect(
            0,
            0,
            16 * columns - 2 * set.frameCropRightOffset,
            16 * rows - 2 * set.frameCropBottomOffset);
    Frame frame =
        new Frame(
            16 * columns,
            16 * rows,
            planes,
            ColorSpace.YUV420,
            shown,
            header.frameNum,
            header.sliceType,
            new MvList2D(4 * columns, 4 * rows),
            new Frame[columns * rows][][],
            2 * header.frameNum);
    frame.setShortTerm(true);
    return frame;
  }

  /** The cropping rectangle of the last frame. */
  Rect shown() {
    return decoded.getCrop();
  }

  /**
   * Returns the number of samples in which the last frame differs from a reconstruction, including
   * chroma and cropped samples.
   */
  long differences(tellosimulator.video.codec.Frame frame) {
    return differences(frame.luma, decoded.getPlaneData(0))
        + differences(frame.cb, decoded.getPlaneData(1))
        + differences(frame.cr, decoded.getPlaneData(2));
  }

  private static long differences(Plane plane, byte[] samples) {
    long count = 0;
    for (int y = 0; y < plane.height; y++) {
      for (int x = 0; x < plane.width; x++) {
        int sample = samples[y * plane.width + x] + OFFSET;
        if (sample != (plane.bytes[plane.offset(x, y)] & 0xFF)) {
          count++;
        }
      }
    }
    return count;
  }
}
