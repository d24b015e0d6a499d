package tellosimulator.scenery.overlay;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import tellosimulator.math.Vec3;

class FlightPathTest {

  private static final int CAPACITY = 64;

  private final FlightPath path = new FlightPath(CAPACITY);

  @Test
  void aDroneThatStandsAddsNothing() {
    assertThat(path.add(Vec3.ZERO)).isTrue();
    for (int i = 0; i < 100; i++) {
      assertThat(path.add(new Vec3(0.001, 0, 0))).isFalse();
    }
    assertThat(path.size()).isEqualTo(1);
  }

  @Test
  void aStraightPartNeedsTwoPoints() {
    for (int i = 0; i <= 30; i++) {
      path.add(new Vec3(0.03 * i, 0, 1));
    }
    assertThat(path.size()).isEqualTo(2);
    assertThat(path.point(1)).isEqualTo(new Vec3(0.03 * 30, 0, 1));
  }

  @Test
  void turningBackIsACorner() {
    path.add(Vec3.ZERO);
    path.add(new Vec3(0.5, 0, 0));
    path.add(new Vec3(0.2, 0, 0));

    assertThat(path.size()).isEqualTo(3);
  }

  @Test
  void howeverLongTheFlightThePathIsBoundedAndKeepsBothEnds() {
    Vec3 last = Vec3.ZERO;
    for (int i = 0; i < 20_000; i++) {
      last = new Vec3(Math.cos(i * 0.1), Math.sin(i * 0.1), i * 0.001);
      path.add(last);
      assertThat(path.size()).isLessThanOrEqualTo(CAPACITY);
    }
    assertThat(path.point(0)).isEqualTo(new Vec3(1, 0, 0));
    assertThat(path.point(path.size() - 1)).isEqualTo(last);
    assertThat(path.size()).isGreaterThan(CAPACITY / 3);
  }

  @Test
  void clearedItBeginsAnew() {
    path.add(Vec3.ZERO);
    path.clear();

    assertThat(path.size()).isZero();
    assertThat(path.add(Vec3.ZERO)).isTrue();
  }
}
