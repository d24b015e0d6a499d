package tellosimulator.time;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TimeFactorTest {

  @ParameterizedTest
  @ValueSource(doubles = {0.01, 1, 20, 5000})
  void finiteFactorsAreLimited(double value) {
    assertThat(new TimeFactor(value).value()).isEqualTo(value);
    assertThat(new TimeFactor(value).unlimited()).isFalse();
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, -1, 0.0099, 5000.1, Double.NaN, Double.NEGATIVE_INFINITY})
  void otherFactorsAreRefusedWithTheAllowedRange(double value) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new TimeFactor(value))
        .withMessage("time factor is " + value + ", but must be from 0.01 to 5000.0, or max");
  }

  @Test
  void maxHasNoLimit() {
    assertThat(TimeFactor.MAX.unlimited()).isTrue();
    assertThat(TimeFactor.MAX).hasToString("max");
    assertThat(TimeFactor.REAL_TIME).hasToString("1.0");
  }
}
