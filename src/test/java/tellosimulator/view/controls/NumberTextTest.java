package tellosimulator.view.controls;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class NumberTextTest {

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          5       | 5
          -12     | -12
          −12     | -12
          +7      | 7
          2,5     | 2.5
          2.5     | 2.5
          ' 300 ' | 300
          .5      | 0.5
          5.      | 5
          """)
  void numbersAreUnderstoodAsPeopleWriteThem(String typed, double number) {
    assertThat(NumberText.parse(typed)).hasValue(number);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        " ",
        "abc",
        "NaN",
        "Infinity",
        "1e9",
        "1d",
        "0x10",
        "1.2.3",
        "5 cm",
        "--1",
        "."
      })
  void everythingElseIsNone(String typed) {
    assertThat(NumberText.parse(typed)).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({"0.4, 0", "-0.4, 0", "-0.6, -1", "-0.0, 0", "99.5, 100", "1234567, 1234567"})
  void wholeNumbersAreNeverMinusZero(double value, String text) {
    assertThat(NumberText.whole(value)).isEqualTo(text);
  }

  @ParameterizedTest
  @CsvSource({"500, 500", "241.3, 241.3", "-0.04, 0", "-241.34, -241.3", "20000, 20000"})
  void oneDecimalIsWrittenWhereItIsNeeded(double value, String text) {
    assertThat(NumberText.of(value, Locale.ENGLISH)).isEqualTo(text);
    assertThat(NumberText.of(value, Locale.GERMAN)).isEqualTo(text.replace('.', ','));
  }

  @ParameterizedTest
  @CsvSource({
    "0, 0:00.0",
    "12.34, 0:12.3",
    "59.999, 0:59.9",
    "125.3, 2:05.3",
    "3599.9, 59:59.9",
    "3600, 1:00:00.0"
  })
  void timeIsMinutesSecondsAndTenths(double seconds, String text) {
    assertThat(NumberText.time(seconds)).isEqualTo(text);
  }

  @Test
  void factorsKeepWhatTheyNeed() {
    assertThat(NumberText.factor(0.25, Locale.ENGLISH)).isEqualTo("0.25 ×");
    assertThat(NumberText.factor(20, Locale.GERMAN)).isEqualTo("20 ×");
  }

  @ParameterizedTest
  @CsvSource({"0,0", "9999,9999", "10000,10 k", "42902,42 k", "1234567,1234 k"})
  void aLargeCountIsInThousands(long count, String text) {
    assertThat(NumberText.count(count)).isEqualTo(text);
  }
}
