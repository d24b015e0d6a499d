package tellosimulator.video.camera;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.scenery.Texture;

class MipMapsTest {

  private static final int RED = 0xffff0000;
  private static final int BLACK = 0xff000000;

  @ParameterizedTest
  @CsvSource({"1, 1, 1", "256, 256, 9", "4, 1024, 11", "104, 8, 8", "300, 200, 10", "3000, 40, 11"})
  void sidesArePowersOfTwoDownToASinglePixel(int width, int height, int levels) {
    MipMaps maps = new MipMaps(filled(width, height, RED), ColorSpace.RGB, false);

    assertThat(maps.levels()).isEqualTo(levels);
    for (int i = 0; i < levels; i++) {
      assertThat(Integer.bitCount(maps.level(i).width())).isEqualTo(1);
      assertThat(Integer.bitCount(maps.level(i).height())).isEqualTo(1);
      assertThat(maps.level(i).width() * maps.uScale(0)).isEqualTo(maps.width() * maps.uScale(i));
      assertThat(maps.level(i).texels()).as("one colour stays one").containsOnly(Lanes.of(RED));
    }
    assertThat(maps.level(levels - 1).width() * maps.level(levels - 1).height()).isEqualTo(1);
  }

  @Test
  void aPixelOfASmallerVersionIsTheMeanOfFour() {
    Texture four = new Texture(2, 2, new int[] {RED, BLACK, BLACK, BLACK});

    MipMaps maps = new MipMaps(four, ColorSpace.RGB, false);

    // 255 / 4 = 63.75
    assertThat(Lanes.packed(maps.level(1).texels()[0])).isEqualTo(0xff400000);
  }

  @Test
  void whatIsTransparentHasNoColourWhereOpacityCounts() {
    Texture texture = new Texture(2, 1, new int[] {0x00ffffff, 0x80ff0000});

    MipMaps masked = new MipMaps(texture, ColorSpace.RGB, true);
    MipMaps opaque = new MipMaps(texture, ColorSpace.RGB, false);

    assertThat(Lanes.packed(masked.level(0).texels()[0])).isZero();
    assertThat(Lanes.packed(masked.level(0).texels()[1])).isEqualTo(0x80800000);
    assertThat(Lanes.packed(opaque.level(0).texels()[0])).isEqualTo(0xffffffff);
    assertThat(Lanes.packed(opaque.level(0).texels()[1])).isEqualTo(RED);
  }

  @Test
  void aTextureOfAnotherSizeKeepsItsPicture() {
    int[] argb = new int[300 * 300];
    Arrays.setAll(argb, i -> i % 300 < 150 ? RED : BLACK);

    MipMaps maps = new MipMaps(new Texture(300, 300, argb), ColorSpace.RGB, false);

    assertThat(maps.width()).isEqualTo(512);
    assertThat(Lanes.packed(maps.color(0.25f, 0.5f))).isEqualTo(RED);
    assertThat(Lanes.packed(maps.color(0.49f, 0.5f))).isEqualTo(RED);
    assertThat(Lanes.packed(maps.color(0.51f, 0.5f))).isEqualTo(BLACK);
    assertThat(Lanes.packed(maps.color(1.25f, -3.5f))).as("it repeats").isEqualTo(RED);
  }

  private static Texture filled(int width, int height, int argb) {
    int[] pixels = new int[width * height];
    Arrays.fill(pixels, argb);
    return new Texture(width, height, pixels);
  }
}
