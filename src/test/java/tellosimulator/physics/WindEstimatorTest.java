package tellosimulator.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;

class WindEstimatorTest {

  private static final double STEP = 0.005;
  private static final Vec3 WIND = new Vec3(3, 0, 0);

  private final WindEstimator estimator = new WindEstimator();

  @Test
  void inStillAirItIsExactlyZeroHoweverFastADroneFlies() {
    estimator.update(new Vec3(4, -2, 1), Vec3.ZERO, STEP);

    assertThat(estimator.push()).isSameAs(Vec3.ZERO);
  }

  /**
   * After its time constant of 0.4 s, a first-order lag has reached 1 - 1/e of the push, which is
   * 63 %.
   */
  @Test
  void aSteadyWindIsKnownLate() {
    double push = DroneSpec.LINEAR_DRAG * 3 + DroneSpec.QUADRATIC_DRAG * 9;

    feel(WIND, 0.4);
    assertThat(estimator.push().x()).isCloseTo(0.632 * push, within(0.01 * push));
    feel(WIND, 4);
    assertThat(estimator.push().x()).isCloseTo(push, within(0.001 * push));
  }

  @Test
  void whenTheAirStandsStillAgainItBecomesExactlyZero() {
    feel(WIND, 2);

    feel(Vec3.ZERO, 8);

    assertThat(estimator.push()).isSameAs(Vec3.ZERO);
  }

  @Test
  void aDroneThatStandsForgetsTheWind() {
    feel(WIND, 2);

    estimator.reset();

    assertThat(estimator.push()).isSameAs(Vec3.ZERO);
  }

  private void feel(Vec3 wind, double seconds) {
    for (int i = 0; i < Math.round(seconds / STEP); i++) {
      estimator.update(Vec3.ZERO, wind, STEP);
    }
  }
}
