package tellosimulator.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Test;

class LocalizedTextTest {

  @Test
  void aPlainLineIsTheSameInAllLanguages() {
    LocalizedText text = LocalizedText.of("Slalom");

    assertThat(text.in(Locale.GERMAN)).isEqualTo("Slalom");
    assertThat(text.in(Locale.ROOT)).isEqualTo("Slalom");
    assertThat(text.english()).isEqualTo("Slalom");
  }

  @Test
  void eachLanguageHasItsLineAndOthersTheEnglishOne() {
    LocalizedText text = new LocalizedText(Map.of("de", "Tor", "en", "Gate"));

    assertThat(text.in(Locale.GERMANY)).isEqualTo("Tor");
    assertThat(text.in(Locale.FRENCH)).isEqualTo("Gate");
    assertThat(text.in(Locale.ROOT)).isEqualTo("Gate");
  }

  @Test
  void withoutEnglishTheFirstLineStandsForOthers() {
    Map<String, String> lines = new LinkedHashMap<>();
    lines.put("fr", "Porte");
    lines.put("de", "Tor");

    assertThat(new LocalizedText(lines).in(Locale.ENGLISH)).isEqualTo("Porte");
  }

  @Test
  void nothingIsAnEmptyLine() {
    assertThat(LocalizedText.of("")).isEqualTo(LocalizedText.NONE);
    assertThat(LocalizedText.NONE.in(Locale.GERMAN)).isEmpty();
  }
}
