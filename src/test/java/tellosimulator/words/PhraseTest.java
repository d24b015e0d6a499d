package tellosimulator.words;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Test;

class PhraseTest {

  private static final Translation GERMAN =
      new Translation() {
        private final Map<String, String> known =
            Map.of(
                "hit %s at %.1f m/s", "mit %2$.1f m/s gegen %1$s geprallt",
                "the ceiling", "die Decke");

        @Override
        public String of(String template) {
          return known.getOrDefault(template, template);
        }

        @Override
        public Locale locale() {
          return Locale.GERMAN;
        }
      };

  @Test
  void valuesAndPartsAreSaidInTheLanguageOfTheWhole() {
    Phrase phrase = Phrase.of("hit %s at %.1f m/s", Phrase.of("the ceiling"), 2.04);

    assertThat(phrase.english()).isEqualTo("hit the ceiling at 2.0 m/s");
    assertThat(phrase.in(GERMAN)).isEqualTo("mit 2,0 m/s gegen die Decke geprallt");
  }

  @Test
  void withoutValuesATemplateIsTakenLiterally() {
    assertThat(Phrase.of("100 % sure").english()).isEqualTo("100 % sure");
  }

  @Test
  void signsInAValueAreNoPlaces() {
    assertThat(Phrase.of("`%s` came", "%d %n").english()).isEqualTo("`%d %n` came");
  }

  @Test
  void phrasesWithTheSameTemplateAndValuesAreEqual() {
    assertThat(Phrase.of("%s", "x")).isEqualTo(Phrase.of("%s", "x")).isNotEqualTo(Phrase.of("x"));
  }
}
