package tellosimulator.report;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Encodes small pictures as JPEG. For one thread at a time; to be closed. */
final class JpegEncoder implements AutoCloseable {

  /**
   * Decided: at this size nobody sees the difference to a better one, which takes twice as much.
   */
  private static final float QUALITY = 0.62f;

  private final ImageWriter writer = ImageIO.getImageWritersByFormatName("jpeg").next();
  private final BufferedImage image;

  JpegEncoder(int width, int height) {
    image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
  }

  /**
   * Encodes a picture.
   *
   * @param pixels row by row from the top
   */
  byte[] encode(int[] pixels) {
    image.getRaster().setDataElements(0, 0, image.getWidth(), image.getHeight(), pixels);
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    ImageWriteParam how = writer.getDefaultWriteParam();
    how.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
    how.setCompressionQuality(QUALITY);
    try (ImageOutputStream out = new MemoryCacheImageOutputStream(bytes)) {
      writer.setOutput(out);
      writer.write(null, new IIOImage(image, null, null), how);
    } catch (IOException e) {
      throw new UncheckedIOException("a picture cannot be encoded in memory", e);
    }
    return bytes.toByteArray();
  }

  @Override
  public void close() {
    writer.dispose();
  }
}
