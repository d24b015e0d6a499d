package tellosimulator.command;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class WireTextTest {

  @Test
  void anyBytesComeBackAsTheyCame() {
    byte[] all = new byte[256];
    for (int i = 0; i < all.length; i++) {
      all[i] = (byte) i;
    }

    String text = WireText.decode(all);

    assertThat(text).hasSize(256);
    assertThat(WireText.encode(text)).isEqualTo(all);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          plain text   | plain text
          a\\tb\\r\\n  | a\\\\x09b\\\\x0d\\\\x0a
          \\33[31m     | \\\\x1b[31m
          \\0\\177     | \\\\x00\\\\x7f
          """)
  void whatIsShownHarmsNoTerminal(String escaped, String shown) {
    assertThat(WireText.printable(escaped.translateEscapes())).isEqualTo(shown.translateEscapes());
  }

  @Test
  void bytesAbove127AreShownAsTheirNumber() {
    assertThat(WireText.printable("\u00e9\u00ff")).isEqualTo("\\xe9\\xff");
  }

  @Test
  void longTextsAreShownInPart() {
    String shown = WireText.printable("x".repeat(2048));

    assertThat(shown).startsWith("x".repeat(80)).endsWith("… (2048 bytes)").hasSizeLessThan(100);
  }
}
