package tellosimulator.view.video;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.jcodec.codecs.png.PNGEncoder;
import org.jcodec.common.model.ColorSpace;
import tellosimulator.video.picture.Picture;
import tellosimulator.video.picture.YuvConverter;

/** Writes pictures as lossless PNG files. Thread-safe. */
final class PngWriter {

  /**
   * Value that is subtracted from each sample. Documented: JCodec's pictures have signed bytes, in
   * which -128 is black.
   */
  private static final int BLACK = 128;

  /**
   * Allowance for the PNG structure around the pixels [bytes]. JCodec's estimate covers only the
   * pixels. Decided: ten times the actual size.
   */
  private static final int FRAME = 1024;

  private PngWriter() {}

  /**
   * Writes a file, which must not exist yet. Writing takes a while.
   *
   * @throws IOException if the file cannot be written
   */
  static void write(Picture picture, Path file) throws IOException {
    ByteBuffer bytes = encoded(picture);
    try (FileChannel channel =
        FileChannel.open(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE)) {
      while (bytes.hasRemaining()) {
        channel.write(bytes);
      }
    }
  }

  private static ByteBuffer encoded(Picture picture) {
    int[] argb = new int[picture.width() * picture.height()];
    YuvConverter.whole(picture, argb);
    org.jcodec.common.model.Picture converted =
        org.jcodec.common.model.Picture.create(picture.width(), picture.height(), ColorSpace.RGB);
    byte[] plane = converted.getPlaneData(0);
    for (int i = 0; i < argb.length; i++) {
      plane[3 * i] = (byte) ((argb[i] >> 16 & 255) - BLACK);
      plane[3 * i + 1] = (byte) ((argb[i] >> 8 & 255) - BLACK);
      plane[3 * i + 2] = (byte) ((argb[i] & 255) - BLACK);
    }
    PNGEncoder encoder = new PNGEncoder();
    ByteBuffer room = ByteBuffer.allocate(encoder.estimateBufferSize(converted) + FRAME);
    return encoder.encodeFrame(converted, room).getData();
  }
}
