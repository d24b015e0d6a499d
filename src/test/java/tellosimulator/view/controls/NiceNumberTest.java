package tellosimulator.view.controls;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NiceNumberTest {

  @ParameterizedTest
  @CsvSource({"75, 100", "100, 100", "101, 200", "201, 500", "3, 5", "0.3, 0.5", "0, 1", "NaN, 1"})
  void isTheNextOneTwoOrFive(double value, double round) {
    assertThat(NiceNumber.atLeast(value)).isEqualTo(round);
  }
}
