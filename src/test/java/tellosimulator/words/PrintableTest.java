package tellosimulator.words;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class PrintableTest {

  @Test
  void whatATerminalObeysIsEscaped() {
    assertThat(Printable.of("a\u001b[31mred\u0007")).isEqualTo("a\\x1b[31mred\\x07");
    assertThat(Printable.of("\u009b31m")).as("CSI in one character").isEqualTo("\\x9b31m");
    assertThat(Printable.of("a\rb")).isEqualTo("a\\x0db");
    assertThat(Printable.of("\u202egnp.exe")).isEqualTo("\\u202egnp.exe");
    assertThat(Printable.of("\u2066x\u2069\u2028")).isEqualTo("\\u2066x\\u2069\\u2028");
    assertThat(Printable.of("\ud800")).isEqualTo("\\ud800");
  }

  @Test
  void wordsOfAllLanguagesStayAsTheyAre() {
    for (String text : new String[] {"Grüße, 東京, 🚁", "می\u200cخواهم", "a\tb\nc", ""}) {
      assertThat(Printable.of(text)).isEqualTo(text);
    }
  }
}
