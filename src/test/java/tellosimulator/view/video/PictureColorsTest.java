package tellosimulator.view.video;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.video.picture.Picture;

class PictureColorsTest {

  /** Documented: the colour bars of ITU-R BT.601 at full strength. */
  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          000000,  16, 128, 128
          ffffff, 235, 128, 128
          ff0000,  81,  90, 240
          00ff00, 145,  54,  34
          0000ff,  41, 240, 110
          ffff00, 210,  16, 146
          """)
  void coloursAreThoseOfTheStandard(String rgb, int y, int u, int v) {
    Picture picture = new Picture(4, 2);
    int[] argb = new int[8];
    Arrays.fill(argb, 0xff000000 | Integer.parseInt(rgb, 16));

    PictureColors.fill(picture, argb);

    assertThat(picture.y()).containsOnly(y);
    assertThat(picture.u()).containsOnly(u);
    assertThat(picture.v()).containsOnly(v);
  }

  @Test
  void backOnTheScreenEvenColoursAreTheSame() {
    Random random = new Random(3);
    int[] there = new int[4];
    int[] back = new int[4];
    Picture picture = new Picture(2, 2);
    for (int i = 0; i < 1000; i++) {
      Arrays.fill(there, 0xff000000 | random.nextInt(1 << 24));
      PictureColors.fill(picture, there);
      ScreenColors.whole(picture, back);
      for (int shift = 0; shift <= 16; shift += 8) {
        // half a step of brightness and half a step of colour, each of at most 2.02
        assertThat(back[0] >> shift & 255)
            .isBetween((there[0] >> shift & 255) - 2, (there[0] >> shift & 255) + 2);
      }
    }
  }
}
