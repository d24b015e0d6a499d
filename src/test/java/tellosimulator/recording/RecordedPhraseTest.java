package tellosimulator.recording;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.json.Json;
import tellosimulator.translation.PhraseCatalog;
import tellosimulator.words.Phrase;
import tellosimulator.words.Translation;

/** Shows phrases that were recorded in English in German. */
class RecordedPhraseTest {

  @Test
  void aPhraseIsSaidInAnotherLanguageAfterwards() {
    Phrase obstacle = Phrase.of("the obstacle \"%s\"", "gate 2");
    Phrase touched = Phrase.of("touched %s at %.1f m/s", obstacle, 0.4);

    Object members = Json.value(Json.text(RecordedPhrase.members(touched)));

    Phrase read = RecordedPhrase.of(members, "");
    assertThat(read.english()).isEqualTo("touched the obstacle \"gate 2\" at 0.4 m/s");
    assertThat(read.in(PhraseCatalog.of(Locale.GERMAN)))
        .isEqualTo("hat das Hindernis „gate 2“ mit 0,4 m/s berührt");
  }

  @Test
  void numbersAreWholeWhereTheirPlacesAre() {
    Phrase phrase = Phrase.of("%,d datagrams from %s turned away: %s", 1234L, 5, "so");

    Object members = Json.value(Json.text(RecordedPhrase.members(phrase)));

    assertThat(RecordedPhrase.of(members, "").english()).isEqualTo(phrase.english());
  }

  /**
   * Each message of the program can be shown in German afterwards; a new kind of placeholder fails.
   */
  @Test
  void eachTemplateIsReadAgain() throws Exception {
    String catalog;
    try (InputStream in = PhraseCatalog.class.getResourceAsStream("phrases_de.txt")) {
      catalog = new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
    List<String> templates =
        catalog.lines().filter(line -> line.startsWith("en: ")).map(l -> l.substring(4)).toList();
    Translation german = PhraseCatalog.of(Locale.GERMAN);

    assertThat(templates).hasSizeGreaterThan(250);
    for (String template : templates) {
      Phrase phrase = new Phrase(template, values(template));
      Object members = Json.value(Json.text(RecordedPhrase.members(phrase)));
      assertThat(RecordedPhrase.of(members, "").in(german)).isEqualTo(phrase.in(german));
    }
  }

  private static List<Object> values(String template) {
    List<Object> values = new ArrayList<>();
    Matcher place = Pattern.compile("%(?:([0-9])\\$)?[,.0-9]*([sdf])").matcher(template);
    while (place.find()) {
      if (place.group(1) == null || Integer.parseInt(place.group(1)) > values.size()) {
        values.add(
            switch (place.group(2)) {
              case "d" -> 1234L;
              case "f" -> 2.5;
              default -> "Q" + values.size();
            });
      }
    }
    return values;
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "null",
        "1",
        "[]",
        "[1]",
        "[\"%s and %s\", 1]",
        "[\"%d\", \"1\"]",
        "[\"%.1f\", [\"a\"]]",
        "[\"%999999999d\", 1]",
        "[\"%s %999999999d\", 1]",
        "[\"%2$s\", 1]",
        "[\"%.1d\", 1]",
        "[\"%,s\", 1]",
        "[\"%.1s\", 1]",
        "[\"50 % of %s\", 1]",
        "[\"%s\", [1]]",
        "[\"%s\", {\"a\":1}]"
      })
  void whatIsNoPhraseIsTheEnglishText(String json) {
    assertThat(RecordedPhrase.of(Json.value(json), "took off").english()).isEqualTo("took off");
  }

  @Test
  void withoutValuesNothingIsAPlace() {
    assertThat(RecordedPhrase.of(Json.value("[\"100 % %s\"]"), "").english()).isEqualTo("100 % %s");
  }
}
