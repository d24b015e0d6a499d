package tellosimulator.scenery.texture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.zip.CRC32;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.testing.Jvm;

class ImageFileTest {

  private static final int RED = 0xffff0000;
  private static final int GREEN = 0xff00ff00;
  private static final int BLUE = 0xff0000ff;

  @TempDir private Path folder;

  @Test
  void theFirstPixelIsAtTheUpperLeft() throws IOException {
    BufferedImage image = new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB);
    image.setRGB(0, 0, RED);
    image.setRGB(1, 0, GREEN);
    image.setRGB(0, 1, BLUE);

    Texture texture = ImageFile.read(saved(image, "png")).texture();

    assertThat(texture.argb(0, 0)).isEqualTo(RED);
    assertThat(texture.argb(texture.width() - 1, 0)).isEqualTo(GREEN);
    assertThat(texture.argb(0, texture.height() - 1)).isEqualTo(BLUE);
  }

  @Test
  void edgesOfASmallImageStaySharp() throws IOException {
    BufferedImage image = new BufferedImage(6, 6, BufferedImage.TYPE_INT_RGB);
    image.setRGB(0, 0, RED);

    Texture texture = ImageFile.read(saved(image, "png")).texture();

    // 256 / 6 = 42.67 pixels to a pixel
    assertThat(texture.width()).isEqualTo(256);
    assertThat(texture.argb(41, 41)).isEqualTo(RED);
    assertThat(texture.argb(43, 41)).isEqualTo(0xff000000);
  }

  @ParameterizedTest
  @CsvSource({
    "256, 256, 256, 256",
    "300, 200, 512, 256",
    "3000, 1500, 1024, 1024",
    "4500, 20, 1024, 256"
  })
  void sizesBecomePowersOfTwoAndTheFormIsKept(int width, int height, int across, int down)
      throws IOException {
    ImageTexture picture =
        ImageFile.read(
            saved(new BufferedImage(width, height, BufferedImage.TYPE_3BYTE_BGR), "jpg"));

    assertThat(picture.texture().width()).isEqualTo(across);
    assertThat(picture.texture().height()).isEqualTo(down);
    assertThat(picture.aspectRatio()).isCloseTo((double) height / width, within(1e-12));
  }

  @Test
  void aLargeImageIsTheMeanOfItsPixels() throws IOException {
    BufferedImage image = new BufferedImage(2048, 2048, BufferedImage.TYPE_INT_RGB);
    for (int x = 0; x < 2048; x++) {
      for (int y = 0; y < 2048; y++) {
        image.setRGB(x, y, (x + y) % 2 == 0 ? 0xffffff : 0);
      }
    }

    Texture texture = ImageFile.read(saved(image, "png")).texture();

    // half white, half black: 127.5
    assertThat(Arrays.stream(texture.argbArray())).containsOnly(0xff808080);
  }

  @ParameterizedTest
  @ValueSource(ints = {BufferedImage.TYPE_BYTE_GRAY, BufferedImage.TYPE_USHORT_GRAY})
  void grayIsAsGrayAsInTheFile(int type) throws IOException {
    BufferedImage image = new BufferedImage(256, 256, type);
    boolean wide = type == BufferedImage.TYPE_USHORT_GRAY;
    int[] gray = new int[256 * 256];
    Arrays.fill(gray, wide ? 100 * 257 : 100);
    image.getRaster().setSamples(0, 0, 256, 256, 0, gray);

    Texture texture = ImageFile.read(saved(image, "png")).texture();

    assertThat(texture.argb(7, 7)).isEqualTo(0xff646464);
  }

  @Test
  void whatIsTransparentStaysTransparentWithoutADarkEdge() throws IOException {
    BufferedImage image = new BufferedImage(512, 3, BufferedImage.TYPE_INT_ARGB);
    for (int x = 0; x < 512; x++) {
      image.setRGB(x, 0, RED);
    }

    Texture texture = ImageFile.read(saved(image, "png")).texture();

    // 256 pixels for 3 rows: a third is 85.33, so row 85 is red by a third of its height
    assertThat(texture.argb(9, 84)).isEqualTo(RED);
    assertThat(texture.argb(9, 85)).isEqualTo(0x55ff0000);
    assertThat(texture.argb(9, 86) >>> 24).isZero();
  }

  @Test
  void noFileIsOneSentence() {
    assertRefused("no-such.png", "there is no file no-such.png");
    assertRefused("\0", "there is no file \0");
    assertRefused(folder.toString(), "the file " + folder + " cannot be read");
  }

  @Test
  void whatIsNoImageIsOneSentence() throws IOException {
    Path text =
        Files.writeString(folder.resolve("text.png"), "no image", StandardCharsets.US_ASCII);
    byte[] image =
        Files.readAllBytes(
            Path.of(saved(new BufferedImage(99, 99, BufferedImage.TYPE_INT_RGB), "png")));
    Path half = Files.write(folder.resolve("half.png"), Arrays.copyOf(image, image.length / 2));

    for (Path file : new Path[] {text, half}) {
      assertRefused(
          file.toString(),
          "the file " + file + " is not an image that can be read (PNG, JPEG, GIF or BMP)");
    }
  }

  @Test
  void aHugeImageIsNotEvenRead() throws IOException {
    for (int[] size : new int[][] {{30_000, 20_000}, {67_000_000, 1}, {1, 67_000_000}}) {
      Path huge = Files.write(folder.resolve("huge.png"), pngHeader(size[0], size[1]));

      assertRefused(
          huge.toString(),
          "the image "
              + huge
              + " has "
              + size[0]
              + " by "
              + size[1]
              + " pixels, but an image may have 32768 along an edge and 67 million in all at the"
              + " most");
    }
  }

  @ParameterizedTest
  @CsvSource({"32768, 2048, png", "2048, 32768, png", "32768, 1, png", "32768, 1024, gif"})
  @Timeout(60)
  void aLongImageTakesLittleMemory(int width, int height, String format) throws IOException {
    String file = saved(new BufferedImage(width, height, BufferedImage.TYPE_BYTE_GRAY), format);
    com.sun.management.ThreadMXBean threads =
        (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    long before = threads.getCurrentThreadAllocatedBytes();

    ImageTexture picture = ImageFile.read(file);

    // At most 4095 pixels of one edge are kept, of the other here 2048: 8 million, each once as it
    // is read (1 byte) and once as 4 bytes; with the rows, half of what was used before.
    assertThat(threads.getCurrentThreadAllocatedBytes() - before).isLessThan(100_000_000);
    assertThat(picture.texture().width()).isEqualTo(width >= 1024 ? 1024 : 256);
  }

  @Test
  void otherFormatsAreNotRead() throws IOException {
    String file = saved(new BufferedImage(9, 9, BufferedImage.TYPE_INT_RGB), "tiff");

    assertRefused(
        file, "the file " + file + " is not an image that can be read (PNG, JPEG, GIF or BMP)");
  }

  @Test
  @Tag("process")
  void tooLittleMemoryIsOneSentence() throws Exception {
    String file = saved(new BufferedImage(4095, 4095, BufferedImage.TYPE_3BYTE_BGR), "png");
    List<String> command = Jvm.commandOf(Reader.class, file);
    command.add(1, "-Xmx32m"); // 4095 * 4095 pixels of 3 bytes are 50 MB
    Process reader = Jvm.process(command).redirectErrorStream(true).start();

    assertThat(reader.inputReader().readLine())
        .isEqualTo("there is not enough memory for the image " + file);
    assertThat(reader.waitFor()).isZero();
  }

  /** Reads an image and prints the error message. */
  static final class Reader {

    private Reader() {}

    public static void main(String[] files) {
      try {
        ImageFile.read(files[0]);
      } catch (IOException e) {
        System.out.println(e.getMessage());
      }
    }
  }

  private static void assertRefused(String file, String sentence) {
    assertThatExceptionOfType(IOException.class)
        .isThrownBy(() -> ImageFile.read(file))
        .withMessage(sentence);
  }

  private String saved(BufferedImage image, String format) throws IOException {
    Path file = folder.resolve("image." + format);
    assertThat(ImageIO.write(image, format, file.toFile())).isTrue();
    return file.toString();
  }

  /** Returns the beginning of a PNG file in true colour. */
  private static byte[] pngHeader(int width, int height) throws IOException {
    ByteArrayOutputStream chunk = new ByteArrayOutputStream();
    DataOutputStream fields = new DataOutputStream(chunk);
    fields.writeBytes("IHDR");
    fields.writeInt(width);
    fields.writeInt(height);
    fields.write(new byte[] {8, 2, 0, 0, 0});
    CRC32 sum = new CRC32();
    sum.update(chunk.toByteArray());
    ByteArrayOutputStream file = new ByteArrayOutputStream();
    DataOutputStream out = new DataOutputStream(file);
    out.writeLong(0x89504e470d0a1a0aL);
    out.writeInt(13);
    out.write(chunk.toByteArray());
    out.writeInt((int) sum.getValue());
    return file.toByteArray();
  }
}
