package tellosimulator.video.picture;

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

/**
 * Encodes pictures of one size as JPEG. Must not be used by two threads at the same time. Must be
 * closed after use.
 */
public final class JpegEncoder implements AutoCloseable {

  private final ImageWriter writer = ImageIO.getImageWritersByFormatName("jpeg").next();
  private final BufferedImage image;
  private final float quality;

  /**
   * Creates an encoder.
   *
   * @param width width of the pictures [pixels]
   * @param height height of the pictures [pixels]
   * @param quality from 0 to 1
   */
  public JpegEncoder(int width, int height, float quality) {
    image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    this.quality = quality;
  }

  /** Encodes a picture of a camera. */
  public static byte[] encode(Picture picture, float quality) {
    int[] pixels = new int[picture.width() * picture.height()];
    YuvConverter.whole(picture, pixels);
    try (JpegEncoder encoder = new JpegEncoder(picture.width(), picture.height(), quality)) {
      return encoder.encode(pixels);
    }
  }

  /**
   * Encodes a picture.
   *
   * @param pixels the pixels as RGB, row by row from the top
   */
  public byte[] encode(int[] pixels) {
    image.getRaster().setDataElements(0, 0, image.getWidth(), image.getHeight(), pixels);
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    ImageWriteParam how = writer.getDefaultWriteParam();
    how.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
    how.setCompressionQuality(quality);
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
