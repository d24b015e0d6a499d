package tellosimulator.scenery.texture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.texture.AlphaMask.Arc;
import tellosimulator.scenery.texture.AlphaMask.Point;

class AlphaMaskTest {

  private static final Rgb INK = Rgb.of(0x123456);

  private final AlphaMask sheet = new AlphaMask(64);

  @Test
  void aStrokeHasItsWidthAndSmoothEdges() {
    sheet.stroke(List.of(new Point(10, 20), new Point(50, 20)), 5);

    Texture drawn = texture(sheet);
    // from 17.5 to 22.5: four pixels whole, and half of two
    assertThat(column(drawn, 30)).isCloseTo(5, within(0.02));
    assertThat(alpha(drawn, 30, 17)).isCloseTo(0.5, within(0.01));
    assertThat(alpha(drawn, 30, 20)).isEqualTo(1);
    assertThat(column(drawn, 60)).isZero();
  }

  @Test
  void theInkHasOneColorAlsoWhereThereIsNone() {
    Texture drawn = texture(sheet.stroke(List.of(new Point(10, 20), new Point(50, 20)), 5));

    for (int argb : drawn.argbArray()) {
      assertThat(argb & 0xffffff).isEqualTo(0x123456);
    }
  }

  @Test
  void aCircleCoversWhatARingCovers() {
    sheet.stroke(Arc.circle(new Point(32, 32), 20).points(), 4);

    // circumference times width: 2 pi 20 times 4
    assertThat(covered(texture(sheet))).isCloseTo(2 * Math.PI * 20 * 4, within(5.0));
    assertThat(alpha(texture(sheet), 32, 32)).isZero();
  }

  @Test
  void aTriangleCoversItsArea() {
    sheet.fill(List.of(new Point(10, 50), new Point(50, 50), new Point(30, 10)));

    // half of 40 times 40
    assertThat(covered(texture(sheet))).isCloseTo(800, within(8.0));
    assertThat(alpha(texture(sheet), 30, 45)).isEqualTo(1);
    assertThat(alpha(texture(sheet), 12, 12)).isZero();
  }

  @Test
  void digitsDifferAndKeepToTheirPlace() {
    Set<List<Integer>> all = new HashSet<>();
    for (char sign : "0123456789-".toCharArray()) {
      AlphaMask sketch = new AlphaMask(64);
      StrokeFont.draw(sketch, sign, new Point(32, 32), 40);
      Texture drawn = texture(sketch);
      assertThat(covered(drawn)).isGreaterThan(50);
      for (int i = 0; i < 64; i++) {
        assertThat(alpha(drawn, 16, i) + alpha(drawn, 47, i)).as("beside %s", sign).isZero();
        assertThat(alpha(drawn, i, 11) + alpha(drawn, i, 52)).as("above %s", sign).isZero();
      }
      all.add(IntStream.of(drawn.argbArray()).boxed().toList());
    }
    assertThat(all).hasSize(11);
  }

  @Test
  void aSevenHasItsBarAboveAndALetterIsRefused() {
    StrokeFont.draw(sheet, '7', new Point(32, 32), 40);

    // the bar is at 32 - 0.425 * 40 = 15
    assertThat(alpha(texture(sheet), 30, 15)).isEqualTo(1);
    assertThat(alpha(texture(sheet), 38, 48)).isZero();
    assertThatIllegalArgumentException()
        .isThrownBy(() -> StrokeFont.draw(sheet, 'z', new Point(32, 32), 40))
        .withMessage("character is z, but must be a digit, -, x, y or →");
  }

  private static Texture texture(AlphaMask mask) {
    return AlphaMask.texture(64, INK, () -> mask);
  }

  private static double covered(Texture drawn) {
    return IntStream.range(0, 64).mapToDouble(x -> column(drawn, x)).sum();
  }

  private static double column(Texture drawn, int x) {
    return IntStream.range(0, 64).mapToDouble(y -> alpha(drawn, x, y)).sum();
  }

  private static double alpha(Texture drawn, int x, int y) {
    return (drawn.argb(x, y) >>> 24) / 255.0;
  }
}
