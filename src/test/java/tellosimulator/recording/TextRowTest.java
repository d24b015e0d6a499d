package tellosimulator.recording;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.time.SimTime;

class TextRowTest {

  private final TextRow row = new TextRow();

  @ParameterizedTest
  @CsvSource({
    "0, 2, 0.00",
    "-0.0, 2, 0.00",
    "-0.004, 2, 0.00",
    "-0.006, 2, -0.01",
    "1.005, 1, 1.0",
    "-12.3456, 3, -12.346",
    "99.96, 1, 100.0",
    "7.5, 0, 8",
    "NaN, 2, ''",
    "Infinity, 2, ''"
  })
  void numbersAreRounded(double number, int decimals, String text) {
    assertThat(row.decimal(number, decimals).take()).isEqualTo(text);
  }

  @ParameterizedTest
  @CsvSource({"0, 0.000", "5000000, 0.005", "61005000000, 61.005", "1234567, 0.001"})
  void momentsAreSecondsToTheMillisecond(long nanos, String text) {
    assertThat(row.seconds(new SimTime(nanos)).take()).isEqualTo(text);
  }

  @Test
  void cellsAreQuotedWhereTheyMustBe() {
    assertThat(row.cell("forward 50").raw(',').cell("a,b").raw(',').cell("\"c\"").take())
        .isEqualTo("forward 50,\"a,b\",\"\"\"c\"\"\"");
  }
}
