package tellosimulator.recording;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CsvRowTest {

  private final CsvRow row = new CsvRow();

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
    assertThat(row.number(number, decimals).toString()).isEqualTo(text);
  }

  @Test
  void cellsAreQuotedWhereTheyMustBe() {
    assertThat(row.text("forward 50").text("a,b").text("\"c\"").toString())
        .isEqualTo("forward 50,\"a,b\",\"\"\"c\"\"\"");
  }
}
