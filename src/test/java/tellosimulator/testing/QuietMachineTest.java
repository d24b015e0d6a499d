package tellosimulator.testing;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class QuietMachineTest {

  @ParameterizedTest
  @CsvSource({"0.5, 2, false", "6, 2, false", "6.1, 2, true", "20, 8, false", "-1, 1, false"})
  void aMachineIsBusyAtAHighLoadForEachProcessor(double load, int processors, boolean busy) {
    assertThat(QuietMachine.verdict(load, processors).isDisabled()).isEqualTo(busy);
  }

  @Test
  void theReasonIsTheSameForAllTestsOfABuild() {
    assertThat(QuietMachine.verdict(9.3, 2).getReason())
        .isEqualTo(QuietMachine.verdict(14.8, 2).getReason())
        .hasValue(
            "needs a quiet machine: a load of at most 6, with no other work at the same time");
  }
}
