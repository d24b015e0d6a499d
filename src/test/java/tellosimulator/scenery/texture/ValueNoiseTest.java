package tellosimulator.scenery.texture;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.texture.ValueNoise.Lattice;

class ValueNoiseTest {

  @Test
  void itIsAsRoughAsWasSaidAndRepeatsWithoutAnEdge() {
    ValueNoise field = new ValueNoise(64).addOctave(new Lattice(8, 4), 0.5, 1);

    double most = 0;
    double steepest = 0;
    for (int x = 0; x < 64; x++) {
      for (int y = 0; y < 64; y++) {
        most = Math.max(most, Math.abs(field.at(x, y)));
        steepest = Math.max(steepest, Math.abs(field.at(x + 1, y) - field.at(x, y)));
      }
    }
    assertThat(most).isBetween(0.2, 0.5);
    // from -0.5 to 0.5 within 8 pixels; in the middle at most one and a half times as steep
    assertThat(steepest).isLessThan(1.5 / 8);
    assertThat(field.at(64, 3)).isEqualTo(field.at(0, 3));
    assertThat(field.at(-1, -1)).isEqualTo(field.at(63, 63));
  }

  @Test
  void theSeedDecides() {
    ValueNoise field = new ValueNoise(16).addOctave(new Lattice(4, 4), 1, 7);

    assertThat(new ValueNoise(16).addOctave(new Lattice(4, 4), 1, 7).at(5, 6))
        .isEqualTo(field.at(5, 6));
    assertThat(new ValueNoise(16).addOctave(new Lattice(4, 4), 1, 8).at(5, 6))
        .isNotEqualTo(field.at(5, 6));
  }

  @Test
  void tonesAreSpreadFromDarkToLightAndSeldomInTheMiddle() {
    ToneTable tones = new ToneTable(100, 3);

    int middle = 0;
    double sum = 0;
    for (int i = 0; i < 100; i++) {
      assertThat(tones.tone(i)).isBetween(0.0, 1.0);
      sum += tones.tone(i);
      middle += tones.tone(i) > 0.25 && tones.tone(i) < 0.75 ? 1 : 0;
    }
    assertThat(sum).isBetween(49.0, 51.0);
    // half of them if evenly spread; here (1/2)^(1/0.55) = 28 %
    assertThat(middle).isBetween(27, 29);
  }

  @Test
  void shadesStayAtTheirEnds() {
    ColorRamp shades = new ColorRamp(Rgb.BLACK, Rgb.of(0xff8000));

    assertThat(shades.argb(-1)).isEqualTo(0xff000000);
    assertThat(shades.argb(2)).isEqualTo(0xffff8000);
    assertThat(shades.argb(0.5)).isEqualTo(0xff804000);
  }

  @Test
  void mixingGoesFromOneColorToTheOther() {
    assertThat(ProceduralTexture.mix(0xff102030, 0xfff0e0d0, 0)).isEqualTo(0xff102030);
    assertThat(ProceduralTexture.mix(0xff102030, 0xfff0e0d0, 3)).isEqualTo(0xfff0e0d0);
    assertThat(ProceduralTexture.mix(0xff102030, 0xfff0e0d0, 0.5)).isEqualTo(0xff808080);
  }
}
