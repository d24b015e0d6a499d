package tellosimulator.video.camera;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
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
      assertThat(colors(maps.level(i))).as("one colour stays one").containsOnly(RED & 0xffffff);
    }
    assertThat(maps.level(levels - 1).width() * maps.level(levels - 1).height()).isEqualTo(1);
  }

  @Test
  void aPixelOfASmallerVersionIsTheMeanOfFour() {
    Texture four = new Texture(2, 2, new int[] {RED, BLACK, BLACK, BLACK});

    MipMaps maps = new MipMaps(four, ColorSpace.RGB, false);

    // 255 / 4 = 63.75
    assertThat(color(maps.level(1), 0, 0)).isEqualTo(0x400000);
  }

  @Test
  void whatIsTransparentHasNoColourWhereOpacityCounts() {
    Texture texture = new Texture(2, 1, new int[] {0x00ffffff, 0x80ff0000});

    MipMaps masked = new MipMaps(texture, ColorSpace.RGB, true);
    MipMaps opaque = new MipMaps(texture, ColorSpace.RGB, false);

    assertThat(color(masked.level(0), 0, 0)).isZero();
    assertThat(masked.level(0).opacity().at(0, 0)).isZero();
    assertThat(color(masked.level(0), 1, 0)).isEqualTo(0x800000);
    assertThat(masked.level(0).opacity().at(1, 0)).isEqualTo(0x80);
    assertThat(color(opaque.level(0), 0, 0)).isEqualTo(0xffffff);
    assertThat(color(opaque.level(0), 1, 0)).isEqualTo(RED & 0xffffff);
  }

  @Test
  void aTextureOfAnotherSizeKeepsItsPicture() {
    int[] argb = new int[300 * 300];
    Arrays.setAll(argb, i -> i % 300 < 150 ? RED : BLACK);

    MipMaps maps = new MipMaps(new Texture(300, 300, argb), ColorSpace.RGB, false);

    assertThat(maps.width()).isEqualTo(512);
    assertThat(color(maps.level(0), 128, 256)).isEqualTo(RED & 0xffffff);
    assertThat(color(maps.level(0), 251, 256)).isEqualTo(RED & 0xffffff);
    assertThat(color(maps.level(0), 261, 256)).as("black").isZero();
  }

  @Test
  void whereColoursAreCoarseTheyAreThoseOfTheNextVersion() {
    Texture four =
        new Texture(4, 4, new SplittableRandom(1).ints(16).map(i -> i | BLACK).toArray());

    MipMaps maps = new MipMaps(four, ColorSpace.YUV, true);

    for (int i = 0; i < 2; i++) {
      Level level = maps.level(i);
      Level next = maps.level(i + 1);
      assertThat(level.second().width()).isEqualTo(level.width() / 2);
      assertThat(level.third().height()).isEqualTo(level.height() / 2);
      assertThat(level.colorOpacity().width()).isEqualTo(next.opacity().width());
      assertThat(next.first().width()).isEqualTo(level.second().width());
    }
    assertThat(maps.level(2).second().width()).as("there is none after the last").isEqualTo(1);
  }

  @Test
  void betweenPixelsTheyAreMixedAndBeyondTheEdgeTheFirstFollowsTheLast() {
    Texture row = new Texture(2, 1, new int[] {0xff000000, 0xff640000});
    Quads reds = new MipMaps(row, ColorSpace.RGB, false).level(0).first();
    Places places = new Places();
    places.room(5);
    places.count = 5;
    places.from(MipMaps.ONE / 2.0, 0);
    places.fill(0, 5, MipMaps.ONE / 2.0, 0);
    places.find(reds);
    int[] values = new int[5];

    reds.read(places, values);

    assertThat(values).containsExactly(0, 50, 100, 50, 0);
  }

  private static IntStream colors(Level level) {
    return IntStream.range(0, level.width() * level.height())
        .map(i -> color(level, i % level.width(), i / level.width()));
  }

  private static int color(Level level, int x, int y) {
    return level.first().at(x, y) << 16 | level.second().at(x, y) << 8 | level.third().at(x, y);
  }

  private static Texture filled(int width, int height, int argb) {
    int[] pixels = new int[width * height];
    Arrays.fill(pixels, argb);
    return new Texture(width, height, pixels);
  }
}
