package tellosimulator.scenery.furniture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.world.ObstacleAppearance.Pattern;
import tellosimulator.world.Shape;

class FinishingTest {

  private static final Rgb BROWN = Rgb.of(0x8b5a2b);
  private static final Rgb RED = Rgb.of(0xc02020);

  @Test
  void shapeAndColorSayWhatAThingIsMadeOf() {
    Shape table = new Shape.Box(0.5, 0.5, 0.6);
    Shape wall = new Shape.Box(0.1, 2, 2);

    assertThat(Finishing.of(table, BROWN)).isEqualTo(Finishing.WOOD);
    assertThat(Finishing.of(table, RED)).isEqualTo(Finishing.FABRIC);
    assertThat(Finishing.of(wall, BROWN)).isEqualTo(Finishing.PAINT);
    assertThat(Finishing.of(new Shape.Cylinder(0.05, 2.5), RED)).isEqualTo(Finishing.METAL);
    assertThat(Finishing.of(new Shape.Cylinder(0.4, 2.5), RED)).isEqualTo(Finishing.PAINT);
    assertThat(Finishing.of(new Shape.Ring(0.5, 0.1, 1), RED)).isEqualTo(Finishing.SEGMENTS);
  }

  @ParameterizedTest
  @EnumSource(value = Finishing.class, names = "SEGMENTS", mode = EnumSource.Mode.EXCLUDE)
  void theColorOfTheFileStaysTheBaseColor(Finishing finishing) {
    Texture texture = texture(finishing, BROWN);

    double red = 0;
    double green = 0;
    double blue = 0;
    int[] pixels = texture.argbArray();
    for (int pixel : pixels) {
      Rgb color = Rgb.of(pixel);
      red += color.red();
      green += color.green();
      blue += color.blue();
    }
    assertThat(red / pixels.length).isCloseTo(BROWN.red(), within(12.0));
    assertThat(green / pixels.length).isCloseTo(BROWN.green(), within(12.0));
    assertThat(blue / pixels.length).isCloseTo(BROWN.blue(), within(12.0));
  }

  @ParameterizedTest
  @CsvSource({"c02020, 9d1a1a", "f0e000, c5b800", "ffffff, d1d1d1"}) // 82 % of it
  void segmentsOfAGateAlternateInShadesOfItsOwnColor(String own, String other) {
    Rgb color = Rgb.of(Integer.parseInt(own, 16));
    Texture texture = texture(Finishing.SEGMENTS, color);

    // a pair is 0.5 m, so 256 texels; the first 60 % are its own
    assertLike(texture.argb(80, 9), color);
    assertLike(texture.argb(200, 9), Rgb.of(Integer.parseInt(other, 16)));
    assertLike(texture.argb(256 + 80, 9), color);
  }

  @ParameterizedTest
  @EnumSource
  void aSmallTextureLooksLikeALargeOne(Finishing finishing) {
    Texture large = texture(finishing, RED);
    Texture small = new PatternTexture(64).of(Pattern.PLAIN, RED, finishing);

    assertThat(small.width()).isEqualTo(64);
    assertLike(small.argb(10, 10), Rgb.of(large.argb(84, 84)));
  }

  private static Texture texture(Finishing finishing, Rgb color) {
    return new PatternTexture(512).of(Pattern.PLAIN, color, finishing);
  }

  private static void assertLike(int argb, Rgb wanted) {
    Rgb color = Rgb.of(argb);
    assertThat(color.red()).isCloseTo(wanted.red(), within(30));
    assertThat(color.green()).isCloseTo(wanted.green(), within(30));
    assertThat(color.blue()).isCloseTo(wanted.blue(), within(30));
  }
}
