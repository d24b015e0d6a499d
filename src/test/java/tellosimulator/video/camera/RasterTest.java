package tellosimulator.video.camera;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import tellosimulator.video.picture.Picture;

class RasterTest {

  private static final int WIDTH = 16;

  /** So many pictures; the same with each run. */
  private static final int PICTURES = 200;

  private static final float NEAR = 0.5f;
  private static final float NEARER = 1;

  private final Picture picture = new Picture(WIDTH, 4);
  private final Raster raster = Raster.on(picture, 2);

  RasterTest() {
    raster.clear();
  }

  @Test
  void eachPixelHasItsBrightnessAndThoseInEvenRowsAndColumnsTheirColour() {
    raster.draw(0, strip(1, 5, 10), NEAR, 0);
    raster.draw(1, strip(1, 5, 20), NEAR, 0);

    assertThat(unsigned(picture.y(), 0, 7)).containsExactly(16, 10, 11, 12, 13, 14, 16);
    assertThat(unsigned(picture.y(), WIDTH, 7)).containsExactly(16, 20, 21, 22, 23, 24, 16);
    assertThat(unsigned(picture.u(), 0, 4)).containsExactly(128, 110, 111, 128);
    assertThat(unsigned(picture.v(), 0, 4)).containsExactly(128, 210, 211, 128);
  }

  @Test
  void belowItsPartOfThePictureNothingChanges() {
    Arrays.fill(picture.y(), (byte) 7);

    raster.clear();
    raster.draw(1, strip(0, WIDTH, 90), NEAR, 0);

    assertThat(unsigned(picture.y(), 2 * WIDTH, 2 * WIDTH)).containsOnly(7);
  }

  @Test
  void whatIsTranslucentIsMixedWithWhatIsBehindAndHidesNothing() {
    raster.draw(0, strip(0, 8, 100), NEAR, 0);
    Strip half = strip(3, 3, 40);
    Arrays.fill(half.opacity, 128);
    Arrays.fill(half.colorOpacity, 128);
    raster.blend(0, half, NEARER, 0, 256);

    // 40 + 103 / 2, 41 + 104 / 2, ...; the colour of column 4: 140 + 202 / 2
    assertThat(unsigned(picture.y(), 2, 5)).containsExactly(102, 91, 92, 94, 106);
    assertThat(unsigned(picture.u(), 1, 3)).containsExactly(201, 240, 203);

    raster.blend(0, half, NEAR / 2, 0, 256);
    assertThat(unsigned(picture.y(), 2, 5)).as("behind").containsExactly(102, 91, 92, 94, 106);

    raster.draw(0, strip(0, 8, 60), (NEAR + NEARER) / 2, 0);
    assertThat(unsigned(picture.y(), 2, 5)).containsExactly(62, 63, 64, 65, 66);
  }

  /** It remembers what was drawn on, so this is tried with many overlaps, odd and even. */
  @Test
  void inWhateverOrderPartsComeTheNearestIsSeen() {
    SplittableRandom random = new SplittableRandom(7);
    for (int i = 0; i < PICTURES; i++) {
      raster.clear();
      int[] wanted = new int[WIDTH];
      float[] nearest = new float[WIDTH];
      Arrays.fill(wanted, 16);
      for (int part = 0; part < 6; part++) {
        int from = random.nextInt(WIDTH);
        int count = 1 + random.nextInt(WIDTH - from);
        float near = 0.1f + random.nextFloat();
        float step = (random.nextFloat() - 0.5f) * 0.01f;
        raster.draw(0, strip(from, count, 20 * part + 20), near, step);
        for (int x = from; x < from + count; x++) {
          float here = near + step * (x - from);
          if (here > nearest[x]) {
            nearest[x] = here;
            wanted[x] = 20 * part + 20 + x - from;
          }
        }
      }

      assertThat(unsigned(picture.y(), 0, WIDTH)).as("picture %d", i).containsExactly(wanted);
    }
  }

  @Test
  void coloursFollowTheBrightnessOfTheirPixel() {
    SplittableRandom random = new SplittableRandom(8);
    for (int i = 0; i < PICTURES; i++) {
      raster.clear();
      for (int part = 0; part < 6; part++) {
        int from = random.nextInt(WIDTH);
        Strip strip = strip(from, 1 + random.nextInt(WIDTH - from), 0);
        Arrays.fill(strip.first, 30 + part);
        Arrays.fill(strip.second, 130 + part);
        raster.draw(0, strip, 0.1f + random.nextFloat(), 0);
      }
      for (int x = 0; x < WIDTH; x += 2) {
        int brightness = picture.y()[x] & 255;
        int wanted = brightness == 16 ? 128 : 100 + brightness;
        assertThat(picture.u()[x / 2] & 255).as("picture %d, column %d", i, x).isEqualTo(wanted);
      }
    }
  }

  /** With brightness a, a + 1, ..., and colours 100 and 200 above a. */
  private static Strip strip(int from, int count, int a) {
    Strip strip = new Strip();
    strip.room(WIDTH);
    strip.from = from;
    strip.count = count;
    Arrays.setAll(strip.first, i -> a + i);
    Arrays.setAll(strip.second, i -> 100 + a + i);
    Arrays.setAll(strip.third, i -> 200 + a + i);
    return strip;
  }

  private static int[] unsigned(byte[] plane, int from, int count) {
    int[] numbers = new int[count];
    Arrays.setAll(numbers, i -> plane[from + i] & 255);
    return numbers;
  }
}
