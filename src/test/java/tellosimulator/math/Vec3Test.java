package tellosimulator.math;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class Vec3Test {

  @Test
  void theCrossProductIsRightHanded() {
    assertThat(new Vec3(1, 0, 0).cross(new Vec3(0, 1, 0))).isEqualTo(Vec3.UP);
  }

  @Test
  void aTurnIsCounterClockwiseSeenFromAbove() {
    Vec3 turned = new Vec3(2, 0, 5).turned(Math.PI / 2);

    assertThat(turned.distanceTo(new Vec3(0, 2, 5))).isLessThan(1e-12);
  }

  @Test
  void onlyLongVectorsAreLimited() {
    assertThat(new Vec3(3, 4, 0).limitedTo(5)).isEqualTo(new Vec3(3, 4, 0));
    assertThat(new Vec3(30, 40, 0).limitedTo(5).distanceTo(new Vec3(3, 4, 0))).isLessThan(1e-12);
    assertThat(Vec3.ZERO.limitedTo(0)).isEqualTo(Vec3.ZERO);
  }

  @Test
  void zeroHasNoDirection() {
    assertThat(Vec3.ZERO.normalized()).isEqualTo(Vec3.ZERO);
    assertThat(new Vec3(0, 0, -7).normalized()).isEqualTo(new Vec3(0, 0, -1));
  }
}
