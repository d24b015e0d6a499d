package tellosimulator.testing;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;

/** Encodes images as files, as the pages contain them. */
public final class CompressedImage {

  private CompressedImage() {}

  /**
   * Returns the bytes of a file.
   *
   * @param format such as {@code png} or {@code jpeg}
   * @param quality of the compression, from 0 (smallest) to 1
   */
  public static byte[] bytes(BufferedImage image, String format, float quality) throws IOException {
    ImageWriter writer = ImageIO.getImageWritersByFormatName(format).next();
    ImageWriteParam compression = writer.getDefaultWriteParam();
    compression.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
    compression.setCompressionQuality(quality);
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ImageOutputStream out = ImageIO.createImageOutputStream(bytes)) {
      writer.setOutput(out);
      writer.write(null, new IIOImage(image, null, null), compression);
    } finally {
      writer.dispose();
    }
    return bytes.toByteArray();
  }
}
