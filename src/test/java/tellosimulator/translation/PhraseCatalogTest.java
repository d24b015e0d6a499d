package tellosimulator.translation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import tellosimulator.scenario.Gallery;
import tellosimulator.view.text.Language;
import tellosimulator.words.Phrase;
import tellosimulator.world.Obstacle;

class PhraseCatalogTest {

  private static final Path SOURCES = Path.of("src/main/java/tellosimulator");

  /** A call that creates a phrase. */
  private static final Pattern CALL = Pattern.compile("\\bPhrase\\s*\\.\\s*of\\(|\\bnew Phrase\\(");

  private static final String LITERAL = "\"(?:[^\"\\\\]|\\\\.)*\"";

  /** The literals, joined by plus signs, at the beginning of a call's arguments. */
  private static final Pattern TEMPLATE =
      Pattern.compile("\\s*(" + LITERAL + "(?:\\s*\\+\\s*" + LITERAL + ")*)\\s*[,)]");

  /** A format specifier: its number if it has one, and its conversion. */
  private static final Pattern PLACE = Pattern.compile("%(?:(\\d+)\\$)?([^a-zA-Z%]*[a-zA-Z%])");

  private static final PhraseCatalog GERMAN = (PhraseCatalog) PhraseCatalog.of(Locale.GERMAN);

  @Test
  void everyPhraseOfTheSourcesHasAGermanTranslationAndNoOther() throws IOException {
    Set<String> all = templates();
    all.addAll(namesInTheGallery());
    assertThat(GERMAN.translations().keySet()).containsExactlyInAnyOrderElementsOf(all);
  }

  /** Returns the names in the program's scenarios; gates are named by letters. */
  private static List<String> namesInTheGallery() {
    return Gallery.NAMES.stream()
        .flatMap(name -> Gallery.find(name).orElseThrow().config().arena().obstacles().stream())
        .map(Obstacle::name)
        .filter(name -> name.length() > 1)
        .toList();
  }

  @Test
  void translationsHavePlacesForTheSameValues() {
    GERMAN
        .translations()
        .forEach(
            (english, german) -> assertThat(places(german)).as(english).isEqualTo(places(english)));
  }

  @Test
  void aPhraseIsSaidInTheChosenLanguage() {
    Language language = new Language(Locale.GERMAN);
    Phrase phrase =
        Phrase.of(
            "`%s` is still running, %s", "up 50", Phrase.of("%.0f of %.0f cm flown", 20.0, 50.0));
    assertThat(language.say(phrase)).isEqualTo("`up 50` läuft noch, 20 von 50 cm geflogen");

    language.localeProperty().set(Locale.ENGLISH);
    assertThat(language.say(phrase)).isEqualTo("`up 50` is still running, 20 of 50 cm flown");
  }

  @Test
  void whatIsNotTranslatedStaysEnglish() {
    assertThat(GERMAN.of("an unknown template")).isEqualTo("an unknown template");
  }

  @Test
  void aLineThatIsNoPartOfAPairIsNamed() {
    assertThatThrownBy(() -> read("en: one\nen: two\n"))
        .hasMessage("expected \"de: \", found \"en: two\"");
    assertThatThrownBy(() -> read("# a comment\nen: one\n"))
        .hasMessage("expected \"de: \", found \"nothing\"");
    assertThatThrownBy(() -> read("en: a\nde: b\n\nen: a\nde: c\n"))
        .hasMessage("\"a\" is translated twice");
  }

  private static PhraseCatalog read(String text) {
    return PhraseCatalog.read(new StringReader(text), Locale.GERMAN);
  }

  private static Set<String> templates() throws IOException {
    List<Path> files;
    try (Stream<Path> all = Files.walk(SOURCES)) {
      files = all.filter(file -> file.toString().endsWith(".java")).toList();
    }
    Set<String> templates = new HashSet<>();
    for (Path file : files) {
      if (!file.endsWith("words/Phrase.java") && !file.endsWith("recording/RecordedPhrase.java")) {
        collect(file, templates);
      }
    }
    return templates;
  }

  private static void collect(Path file, Set<String> templates) throws IOException {
    String source = Files.readString(file);
    Matcher call = CALL.matcher(source);
    while (call.find()) {
      Matcher template = TEMPLATE.matcher(source).region(call.end(), source.length());
      assertThat(template.lookingAt())
          .as("%s: the template after position %d is written out", file, call.start())
          .isTrue();
      templates.add(
          Pattern.compile(LITERAL)
              .matcher(template.group(1))
              .results()
              .map(MatchResult::group)
              .map(literal -> literal.substring(1, literal.length() - 1).translateEscapes())
              .collect(Collectors.joining()));
    }
  }

  /** Returns the conversion of each value, by its number. */
  private static Map<Integer, Set<String>> places(String template) {
    Map<Integer, Set<String>> places = new TreeMap<>();
    int next = 1;
    for (MatchResult place : PLACE.matcher(template).results().toList()) {
      if (!place.group(2).equals("%")) {
        int number = place.group(1) == null ? next++ : Integer.parseInt(place.group(1));
        places.computeIfAbsent(number, unused -> new HashSet<>()).add(place.group(2));
      }
    }
    return places;
  }
}
