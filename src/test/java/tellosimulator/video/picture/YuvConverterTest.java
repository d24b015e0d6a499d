package tellosimulator.video.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class YuvConverterTest {

  /** Documented: the colour bars of ITU-R BT.601 at full strength, and values beyond. */
  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
           16, 128, 128, 000000
          235, 128, 128, ffffff
          126, 128, 128, 808080
           81,  90, 240, ff0000
          145,  54,  34, 00ff00
           41, 240, 110, 0000ff
          210,  16, 146, ffff00
          255, 128, 128, ffffff
            0,   0,   0, 008700
          """)
  void colorsAreThoseOfTheStandard(int y, int u, int v, String rgb) {
    Picture picture = picture(y, u, v);
    int[] whole = new int[16];
    int[] half = new int[4];

    YuvConverter.whole(picture, whole);
    YuvConverter.half(picture, half);

    int wanted = Integer.parseInt(rgb, 16);
    assertThat(Arrays.stream(whole).boxed()).allSatisfy(pixel -> assertNear(pixel, wanted));
    assertThat(half).containsOnly(whole[0]);
  }

  @Test
  void eachPixelHasItsOwnBrightnessAndFourShareAColor() {
    Picture picture = picture(100, 128, 128);
    picture.y()[6] = (byte) 200; // third column, second row
    picture.u()[3] = (byte) 200; // lower right
    int[] whole = new int[16];
    int[] half = new int[4];

    YuvConverter.whole(picture, whole);
    YuvConverter.half(picture, half);

    // (200 - 16) 255 / 219 = 214, (100 - 16) 255 / 219 = 98
    assertThat(whole[6]).isEqualTo(0xffd6d6d6);
    assertThat(whole[2]).isEqualTo(0xff626262);
    assertThat(Arrays.stream(new int[] {10, 11, 14, 15}).map(i -> whole[i]))
        .containsOnly(whole[10])
        .allMatch(pixel -> (pixel & 255) > 200);
    // the mean of 100, 100, 100 and 200 is 125
    assertThat(half[1]).isEqualTo(0xff7f7f7f);
    assertThat(half[0]).isEqualTo(0xff626262);
  }

  private static Picture picture(int y, int u, int v) {
    Picture picture = new Picture(4, 4);
    Arrays.fill(picture.y(), (byte) y);
    Arrays.fill(picture.u(), (byte) u);
    Arrays.fill(picture.v(), (byte) v);
    return picture;
  }

  private static void assertNear(int pixel, int wanted) {
    assertThat(pixel >>> 24).isEqualTo(255);
    for (int shift = 0; shift <= 16; shift += 8) {
      assertThat((pixel >> shift) & 255)
          .isBetween(((wanted >> shift) & 255) - 2, ((wanted >> shift) & 255) + 2);
    }
  }
}
