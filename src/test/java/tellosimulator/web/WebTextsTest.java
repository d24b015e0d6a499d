package tellosimulator.web;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Map;
import java.util.MissingResourceException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

final class WebTextsTest {

  private static String page(String name) throws IOException {
    try (InputStream in = WebTexts.class.getResourceAsStream(name)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  @ParameterizedTest
  @CsvSource({"page.html,en", "page.html,de", "board.html,en", "board.html,de"})
  void everyPlaceOfAPageHasAText(String name, String language) throws IOException {
    String filled =
        new WebTexts(Locale.forLanguageTag(language))
            .filled(page(name), Map.of("token", "t", "language", language));

    assertThat(filled).doesNotContain("{{").contains("lang=\"" + language + "\"");
  }

  @Test
  void languagesDiffer() {
    assertThat(new WebTexts(Locale.ENGLISH).text("pilot.land")).isEqualTo("Land");
    assertThat(new WebTexts(Locale.GERMAN).text("pilot.land")).isEqualTo("Landen");
    assertThat(new WebTexts(Locale.GERMAN).text("web.close")).isEqualTo("Schließen");
  }

  @Test
  void valuesAreNoMarkup() {
    String filled =
        new WebTexts(Locale.ENGLISH).filled("<p a=\"{{token}}\">", Map.of("token", "\"><script>&"));

    assertThat(filled).isEqualTo("<p a=\"&quot;&gt;&lt;script&gt;&amp;\">");
  }

  @Test
  void aTextThatIsMissingIsAnError() {
    assertThatThrownBy(() -> new WebTexts(Locale.ENGLISH).text("web.nothing"))
        .isInstanceOf(MissingResourceException.class);
  }
}
