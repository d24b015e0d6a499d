package tellosimulator.scenery.furniture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

class ShadowLayerTest {

  private static final int SIZE = 16;

  private final ShadowLayer layer = new ShadowLayer(SIZE);

  @Test
  void texelsWhoseCentersAreInATriangleAreShaded() {
    layer.fill(new double[] {2, 6, 2}, new double[] {2, 2, 6});

    assertThat(shaded()).isEqualTo(4 + 3 + 2 + 1); // the long edge goes through the last centres
    assertThat(at(2, 2)).isEqualTo(1);
    assertThat(at(5, 5)).isZero();
    assertThat(at(1, 2)).isZero();
    assertThat(at(2, 6)).isZero();
  }

  @Test
  void whatIsOutsideIsLeftOut() {
    layer.fill(new double[] {-5, 40, 40, -5}, new double[] {12, 12, 40, 40});

    assertThat(shaded()).isEqualTo(4 * SIZE);
  }

  @Test
  void nothingHasNoShade() {
    layer.fill(new double[] {}, new double[] {});

    assertThat(shaded()).isZero();
  }

  @Test
  void aBlurSpreadsTheShadeEvenlyAndKeepsItsSum() {
    layer.fill(new double[] {8, 9, 9, 8}, new double[] {8, 8, 9, 9});

    layer.blur(1, 2);

    assertThat(shaded()).isEqualTo(1, within(1e-6));
    assertThat(at(8, 8)).isEqualTo(1.0 / 3 / 5, within(1e-6)); // the peaks of two triangles
    assertThat(at(6, 8)).isEqualTo(at(10, 8), within(1e-6)).isPositive();
    assertThat(at(8, 4)).isEqualTo(at(8, 12), within(1e-6)).isPositive();
    assertThat(at(5, 8)).isZero();
  }

  @Test
  void aBlurIsNeverWiderThanTheTexture() {
    layer.fill(new double[] {8, 9, 9, 8}, new double[] {8, 8, 9, 9});

    layer.blur(1e12, 1e12);

    assertThat(at(3, 3)).isPositive();
  }

  @Test
  void shadeAtAnEdgeGoesOnBeyondIt() {
    layer.fill(new double[] {0, SIZE, SIZE, 0}, new double[] {0, 0, SIZE, SIZE});

    layer.blur(3, 3);

    assertThat(at(0, 0)).isEqualTo(1, within(1e-6));
  }

  private double shaded() {
    return Arrays.stream(sums()).sum();
  }

  private double at(int column, int row) {
    return sums()[row * SIZE + column];
  }

  private double[] sums() {
    double[] sums = new double[SIZE * SIZE];
    layer.addTo(sums);
    return sums;
  }
}
