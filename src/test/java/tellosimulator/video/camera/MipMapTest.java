package tellosimulator.video.camera;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.scenery.mesh.Texture;

class MipMapTest {

  private static final int RED = 0xffff0000;
  private static final int BLACK = 0xff000000;

  @ParameterizedTest
  @CsvSource({"1, 1, 1", "256, 256, 9", "4, 1024, 11", "104, 8, 8", "300, 200, 10", "3000, 40, 11"})
  void sidesArePowersOfTwoDownToASinglePixel(int width, int height, int levels) {
    MipMap mipMap = new MipMap(filled(width, height, RED), ColorSpace.RGB, false);

    assertThat(mipMap.levels()).isEqualTo(levels);
    for (int i = 0; i < levels; i++) {
      assertThat(Integer.bitCount(mipMap.level(i).width())).isEqualTo(1);
      assertThat(Integer.bitCount(mipMap.level(i).height())).isEqualTo(1);
      assertThat(mipMap.level(i).width() * mipMap.uScale(0))
          .isEqualTo(mipMap.width() * mipMap.uScale(i));
      assertThat(colors(mipMap.level(i))).as("one colour stays one").containsOnly(RED & 0xffffff);
    }
    assertThat(mipMap.level(levels - 1).width() * mipMap.level(levels - 1).height()).isEqualTo(1);
  }

  @Test
  void aTexelOfTheNextLevelIsTheMeanOfFour() {
    Texture four = new Texture(2, 2, new int[] {RED, BLACK, BLACK, BLACK});

    MipMap mipMap = new MipMap(four, ColorSpace.RGB, false);

    // 255 / 4 = 63.75
    assertThat(color(mipMap.level(1), 0, 0)).isEqualTo(0x400000);
  }

  @Test
  void colorsArePremultipliedWhereAlphaCounts() {
    Texture texture = new Texture(2, 1, new int[] {0x00ffffff, 0x80ff0000});

    MipMap translucent = new MipMap(texture, ColorSpace.RGB, true);
    MipMap opaque = new MipMap(texture, ColorSpace.RGB, false);

    assertThat(color(translucent.level(0), 0, 0)).isZero();
    assertThat(translucent.level(0).alpha().texel(0, 0)).isZero();
    assertThat(color(translucent.level(0), 1, 0)).isEqualTo(0x800000);
    assertThat(translucent.level(0).alpha().texel(1, 0)).isEqualTo(0x80);
    assertThat(color(opaque.level(0), 0, 0)).isEqualTo(0xffffff);
    assertThat(color(opaque.level(0), 1, 0)).isEqualTo(RED & 0xffffff);
  }

  @Test
  void texturesOfOtherSizesAreResampled() {
    int[] argb = new int[300 * 300];
    Arrays.setAll(argb, i -> i % 300 < 150 ? RED : BLACK);

    MipMap mipMap = new MipMap(new Texture(300, 300, argb), ColorSpace.RGB, false);

    assertThat(mipMap.width()).isEqualTo(512);
    assertThat(color(mipMap.level(0), 128, 256)).isEqualTo(RED & 0xffffff);
    assertThat(color(mipMap.level(0), 251, 256)).isEqualTo(RED & 0xffffff);
    assertThat(color(mipMap.level(0), 261, 256)).as("black").isZero();
  }

  @Test
  void subsampledChromaIsThatOfTheNextLevel() {
    Texture four =
        new Texture(4, 4, new SplittableRandom(1).ints(16).map(i -> i | BLACK).toArray());

    MipMap mipMap = new MipMap(four, ColorSpace.YUV, true);

    for (int i = 0; i < 2; i++) {
      MipMap.Level level = mipMap.level(i);
      MipMap.Level next = mipMap.level(i + 1);
      assertThat(level.second().width()).isEqualTo(level.width() / 2);
      assertThat(level.third().height()).isEqualTo(level.height() / 2);
      assertThat(level.chromaAlpha().width()).isEqualTo(next.alpha().width());
      assertThat(next.first().width()).isEqualTo(level.second().width());
    }
    assertThat(mipMap.level(2).second().width()).as("there is none after the last").isEqualTo(1);
  }

  @Test
  void samplesAreBilinearAndWrapAround() {
    Texture row = new Texture(2, 1, new int[] {0xff000000, 0xff640000});
    BilinearTexels reds = new MipMap(row, ColorSpace.RGB, false).level(0).first();
    TextureCoordinates coordinates = new TextureCoordinates();
    coordinates.ensureCapacity(5);
    coordinates.count = 5;
    coordinates.setStart(MipMap.ONE / 2.0, 0);
    coordinates.interpolate(0, 5, MipMap.ONE / 2.0, 0);
    coordinates.computeIndices(reds);
    int[] values = new int[5];

    reds.sample(coordinates, values);

    assertThat(values).containsExactly(0, 50, 100, 50, 0);
  }

  private static IntStream colors(MipMap.Level level) {
    return IntStream.range(0, level.width() * level.height())
        .map(i -> color(level, i % level.width(), i / level.width()));
  }

  private static int color(MipMap.Level level, int x, int y) {
    return level.first().texel(x, y) << 16
        | level.second().texel(x, y) << 8
        | level.third().texel(x, y);
  }

  private static Texture filled(int width, int height, int argb) {
    int[] pixels = new int[width * height];
    Arrays.fill(pixels, argb);
    return new Texture(width, height, pixels);
  }
}
