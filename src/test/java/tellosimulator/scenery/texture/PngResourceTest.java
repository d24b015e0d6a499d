package tellosimulator.scenery.texture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.zip.DataFormatException;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;

/** The JDK's own reader and writer are the judges. */
class PngResourceTest {

  @Test
  void theTexturesOfTheRoomAreDecodedAsTheJdkDoes() throws IOException, DataFormatException {
    for (String name : List.of("boards", "bricks", "hexagons", "panels", "parquet", "triangles")) {
      byte[] png =
          PngResource.class
              .getResourceAsStream("/tellosimulator/scenery/room/" + name + ".png")
              .readAllBytes();
      BufferedImage image = ImageIO.read(new ByteArrayInputStream(png));

      assertThat(
              PngResource.decode(
                  new DataInputStream(new ByteArrayInputStream(png)), image.getWidth()))
          .as(name)
          .isEqualTo(pixels(image));
    }
  }

  @Test
  void filteredRowsAreDecodedAsTheJdkDoes() throws IOException, DataFormatException {
    byte[] png = png(BufferedImage.TYPE_BYTE_INDEXED, 64);

    assertThat(PngResource.decode(new DataInputStream(new ByteArrayInputStream(png)), 64))
        .isEqualTo(pixels(ImageIO.read(new ByteArrayInputStream(png))));
  }

  @Test
  void whatIsNoSquareOfTheSizeWithAPaletteIsRefused() throws IOException {
    assertRefused(png(BufferedImage.TYPE_INT_RGB, 64), 64, "8-bit palette, and pixels 64 by 64");
    assertRefused(
        png(BufferedImage.TYPE_BYTE_INDEXED, 32), 64, "8-bit palette, and pixels 64 by 64");
    assertRefused(new byte[64], 64, "no PNG");
  }

  private static void assertRefused(byte[] file, int size, String reason) {
    assertThatThrownBy(
            () -> PngResource.decode(new DataInputStream(new ByteArrayInputStream(file)), size))
        .isInstanceOf(IOException.class)
        .hasMessageContaining(reason);
  }

  private static byte[] png(int type, int size) throws IOException {
    BufferedImage image = new BufferedImage(size, size, type);
    for (int y = 0; y < size; y++) {
      for (int x = 0; x < size; x++) {
        // smooth above, rough below
        int green = y < size / 2 ? 4 * x : x * x * 37 + y * y * 91;
        image.setRGB(
            x, y, 0xff000000 | ((3 * y) & 255) << 16 | (green & 255) << 8 | ((x * y) & 255));
      }
    }
    ByteArrayOutputStream file = new ByteArrayOutputStream();
    ImageIO.write(image, "png", file);
    return file.toByteArray();
  }

  private static int[] pixels(BufferedImage image) {
    int width = image.getWidth();
    int[] pixels = image.getRGB(0, 0, width, image.getHeight(), null, 0, width);
    return Arrays.stream(pixels).map(pixel -> pixel | 0xff000000).toArray();
  }
}
