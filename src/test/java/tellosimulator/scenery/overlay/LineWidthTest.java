package tellosimulator.scenery.overlay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import tellosimulator.math.Vec3;

class LineWidthTest {

  private final LineWidth width = new LineWidth(new Vec3(-1, 0, 1));

  @Test
  void fromNearALineIsEquallyThickInThePicture() {
    assertThat(width.half(at(4)) / 4).isCloseTo(width.half(at(2)) / 2, within(1e-12));
    assertThat(width.half(at(2))).isEqualTo(0.0028, within(1e-12)); // 0.0014 of 2 m
  }

  @Test
  void itIsNeverThickerThanFromAfarNorSoFineThatItVanishes() {
    assertThat(width.half(at(20))).isEqualTo(width.half(at(6))).isEqualTo(LineWidth.MOST);
    assertThat(width.half(at(0))).isEqualTo(width.half(at(0.5))).isGreaterThan(0.001);
  }

  @Test
  void aSmallStepOfTheCameraSuitsALargeOneDoesNot() {
    assertThat(width.suits(new LineWidth(new Vec3(-1.2, 0, 1)), at(2))).isTrue();
    assertThat(width.suits(new LineWidth(new Vec3(-1.8, 0, 1)), at(2))).as("finer").isFalse();
    assertThat(width.suits(new LineWidth(new Vec3(-0.4, 0, 1)), at(2))).as("thicker").isFalse();
    assertThat(width.suits(new LineWidth(new Vec3(-9, 0, 1)), at(9))).as("both far").isTrue();
  }

  /** Returns a place at a distance ahead of the camera [m]. */
  private static Vec3 at(double distance) {
    return new Vec3(-1 + distance, 0, 1);
  }
}
