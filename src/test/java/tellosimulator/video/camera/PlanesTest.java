package tellosimulator.video.camera;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import tellosimulator.video.picture.Picture;

class PlanesTest {

  private final Raster raster = new Raster(4, 2);
  private final Picture picture = new Picture(4, 2);

  @Test
  void eachPixelHasItsBrightnessAndFourTheMeanOfTheirColours() {
    int[] pixels = raster.pixels();
    Arrays.setAll(pixels, i -> packed(10 * i, 200, 30));
    pixels[0] = packed(1, 255, 0);
    pixels[5] = packed(2, 240, 4);

    Planes.write(raster, picture);

    assertThat(unsigned(picture.y())).containsExactly(1, 10, 20, 30, 40, 2, 60, 70);
    // (255 + 200 + 200 + 240) / 4 = 223.75, (0 + 30 + 30 + 4) / 4 = 16
    assertThat(unsigned(picture.u())).containsExactly(224, 200);
    assertThat(unsigned(picture.v())).containsExactly(16, 30);
  }

  @Test
  void aGreyPictureHasNoColourAndIsGreenBelow() {
    Picture high = new Picture(4, 6);
    Arrays.fill(high.y(), (byte) 99);
    Arrays.setAll(raster.pixels(), i -> packed(200 + i, 77, 99));

    Planes.writeGrey(raster, high);

    assertThat(Arrays.copyOf(unsigned(high.y()), 8))
        .containsExactly(200, 201, 202, 203, 204, 205, 206, 207);
    assertThat(Arrays.copyOfRange(high.y(), 8, 24)).containsOnly(0);
    assertThat(unsigned(high.u())).containsExactly(128, 128, 0, 0, 0, 0);
    assertThat(unsigned(high.v())).containsExactly(128, 128, 0, 0, 0, 0);
  }

  private static int packed(int y, int u, int v) {
    return 0xff000000 | u << 16 | y << 8 | v;
  }

  private static int[] unsigned(byte[] plane) {
    int[] numbers = new int[plane.length];
    Arrays.setAll(numbers, i -> plane[i] & 255);
    return numbers;
  }
}
