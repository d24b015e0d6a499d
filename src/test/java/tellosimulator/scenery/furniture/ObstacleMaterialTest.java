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

class ObstacleMaterialTest {

  private static final Rgb BROWN = Rgb.of(0x8b5a2b);
  private static final Rgb RED = Rgb.of(0xc02020);

  @Test
  void shapeAndColorSayWhatAThingIsMadeOf() {
    Shape table = new Shape.Box(0.5, 0.5, 0.6);
    Shape wall = new Shape.Box(0.1, 2, 2);

    assertThat(ObstacleMaterial.of(table, BROWN)).isEqualTo(ObstacleMaterial.WOOD);
    assertThat(ObstacleMaterial.of(table, RED)).isEqualTo(ObstacleMaterial.FABRIC);
    assertThat(ObstacleMaterial.of(wall, BROWN)).isEqualTo(ObstacleMaterial.PAINT);
    assertThat(ObstacleMaterial.of(new Shape.Cylinder(0.05, 2.5), RED))
        .isEqualTo(ObstacleMaterial.METAL);
    assertThat(ObstacleMaterial.of(new Shape.Cylinder(0.4, 2.5), RED))
        .isEqualTo(ObstacleMaterial.PAINT);
    assertThat(ObstacleMaterial.of(new Shape.Ring(0.5, 0.1, 1), RED))
        .isEqualTo(ObstacleMaterial.SEGMENTS);
  }

  @ParameterizedTest
  @EnumSource(value = ObstacleMaterial.class, names = "SEGMENTS", mode = EnumSource.Mode.EXCLUDE)
  void theColorOfTheFileStaysTheBaseColor(ObstacleMaterial material) {
    Texture texture = texture(material, BROWN);

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
  @CsvSource({"c02020, 9d1a1a", "f0e000, c5b800", "ffffff, d1d1d1"}) // 82 % of the colour
  void segmentsOfAGateAlternateInShadesOfItsOwnColor(String own, String other) {
    Rgb color = Rgb.of(Integer.parseInt(own, 16));
    Texture texture = texture(ObstacleMaterial.SEGMENTS, color);

    // a pair is 0.5 m, so 256 texels; the first 60 % are its own
    assertLike(texture.argb(80, 9), color);
    assertLike(texture.argb(200, 9), Rgb.of(Integer.parseInt(other, 16)));
    assertLike(texture.argb(256 + 80, 9), color);
  }

  @ParameterizedTest
  @EnumSource
  void aSmallTextureLooksLikeALargeOne(ObstacleMaterial material) {
    Texture large = texture(material, RED);
    Texture small = new PatternTexture(64).of(Pattern.PLAIN, RED, material);

    assertThat(small.width()).isEqualTo(64);
    assertLike(small.argb(10, 10), Rgb.of(large.argb(84, 84)));
  }

  private static Texture texture(ObstacleMaterial material, Rgb color) {
    return new PatternTexture(512).of(Pattern.PLAIN, color, material);
  }

  private static void assertLike(int argb, Rgb wanted) {
    Rgb color = Rgb.of(argb);
    assertThat(color.red()).isCloseTo(wanted.red(), within(30));
    assertThat(color.green()).isCloseTo(wanted.green(), within(30));
    assertThat(color.blue()).isCloseTo(wanted.blue(), within(30));
  }
}
