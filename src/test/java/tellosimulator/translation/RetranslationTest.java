package tellosimulator.translation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.words.Phrase;
import tellosimulator.words.Retranslation;
import tellosimulator.words.Translation;

/** What is kept in English words is said in German afterwards. */
class RetranslationTest {

  private static final Pattern PLACE = Pattern.compile("%,?(?:\\.\\d)?([sdf])");

  private final Translation german = PhraseCatalog.of(Locale.GERMAN);
  private final Retranslation retranslation = new Retranslation(german);

  @Test
  void eachTemplateIsFoundAgain() {
    List<String> wrong = new ArrayList<>();
    for (String template : german.templates()) {
      Phrase phrase = new Phrase(template, values(template));
      if (!retranslation.of(phrase.english()).equals(phrase.in(german))) {
        wrong.add(phrase.english() + " became " + retranslation.of(phrase.english()));
      }
    }

    // %s or %s, %s; %s and the like say too little to be told from each other
    assertThat(german.templates()).hasSizeGreaterThan(250);
    assertThat(wrong).hasSizeLessThan(8);
  }

  private static List<Object> values(String template) {
    List<Object> values = new ArrayList<>();
    Matcher place = PLACE.matcher(template);
    while (place.find()) {
      values.add(
          switch (place.group(1)) {
            case "d" -> 1234L;
            case "f" -> 2.5;
            default -> "Q" + values.size();
          });
    }
    return values;
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          took off                                       | ist gestartet
          touched the obstacle "gate 2" at 0.4 m/s         | hat das Hindernis „gate 2“ mit 0,4 m/s berührt
          crashed into the front wall at 1.9 m/s; its motors stay off until reset or power cycle | ist mit 1,9 m/s gegen die vordere Wand geprallt; ihre Motoren bleiben aus, bis sie zurückgesetzt oder neu eingeschaltet wird
          `took off` answered `took off`                 | `took off` beantwortet mit `took off`
          `cw 90` refused: `forward 100` is still running, 20 of 100 cm flown; answered `error Not joystick` | `cw 90` abgelehnt: `forward 100` läuft noch, 20 von 100 cm geflogen; Antwort `error Not joystick`
          nobody says this                               | nobody says this
          """)
  void sentencesAreSaidInGerman(String english, String said) {
    assertThat(retranslation.of(english)).isEqualTo(said);
  }

  @Test
  void englishStaysAsItIs() {
    assertThat(new Retranslation(Translation.ENGLISH).of("took off")).isEqualTo("took off");
  }
}
