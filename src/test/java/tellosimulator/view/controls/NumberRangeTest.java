package tellosimulator.view.controls;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NumberRangeTest {

  private static final NumberRange START = new NumberRange(-241.3, 241.3, 10);

  @ParameterizedTest
  @CsvSource({"3, 0", "-7, -10", "238, 240", "241.3, 241.3", "300, 241.3", "-999, -241.3"})
  void sliderValuesAreMultiplesOfTheStepOrAnEnd(double value, double snapped) {
    assertThat(START.snapped(value)).isEqualTo(snapped);
  }

  @ParameterizedTest
  @CsvSource({"0, 1, 10", "0, -1, -10", "3, 1, 10", "3, -1, 0", "240, 1, 241.3", "241.3, -1, 240"})
  void arrowKeysGoToTheNextMultiple(double value, int direction, double next) {
    assertThat(START.next(value, direction)).isEqualTo(next);
  }

  @Test
  void endsBelongToTheRange() {
    assertThat(START.contains(241.3)).isTrue();
    assertThat(START.contains(241.4)).isFalse();
    assertThat(START.contains(Double.NaN)).isFalse();
  }

  @Test
  void aRangeThatIsNoneIsRefused() {
    assertThatThrownBy(() -> new NumberRange(2, 1, 1)).isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> new NumberRange(0, Double.NaN, 1))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
