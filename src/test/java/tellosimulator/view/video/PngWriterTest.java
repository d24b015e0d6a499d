package tellosimulator.view.video;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.video.picture.Picture;
import tellosimulator.video.picture.YuvConverter;

class PngWriterTest {

  @TempDir private Path folder;

  @ParameterizedTest
  @CsvSource({"960, 720", "648, 478", "320, 720", "2, 2"})
  void anotherProgramReadsEachPixelAsItIsOnTheScreen(int width, int height) throws IOException {
    Picture picture = noise(width, height);
    Path file = folder.resolve("still.png");

    PngWriter.write(picture, file);

    int[] wanted = new int[width * height];
    YuvConverter.whole(picture, wanted);
    BufferedImage image = ImageIO.read(file.toFile());
    assertThat(image.getWidth()).isEqualTo(width);
    assertThat(image.getRGB(0, 0, width, height, null, 0, width)).isEqualTo(wanted);
  }

  @Test
  void aFileThatExistsIsNotOverwritten() throws IOException {
    Path precious = Files.writeString(folder.resolve("precious.png"), "x");

    assertThatThrownBy(() -> PngWriter.write(noise(2, 2), precious))
        .isInstanceOf(FileAlreadyExistsException.class);
    assertThat(Files.readString(precious)).isEqualTo("x");
  }

  /** Returns random samples, which compress worst. */
  private static Picture noise(int width, int height) {
    Picture picture = new Picture(width, height);
    Random random = new Random(7);
    random.nextBytes(picture.y());
    random.nextBytes(picture.u());
    random.nextBytes(picture.v());
    return picture;
  }
}
