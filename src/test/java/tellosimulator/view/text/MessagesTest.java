package tellosimulator.view.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Properties;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The texts of the window have format specifiers like the phrases of the core. */
class MessagesTest {

  private static final Path RESOURCES = Path.of("src/main/resources/tellosimulator");
  private static final Pattern PLACE = Pattern.compile("%(\\d\\$)?,?(\\.\\d)?[sdf]");

  static List<Path> english() throws IOException {
    try (Stream<Path> files = Files.walk(RESOURCES)) {
      return files.filter(file -> file.endsWith("messages.properties")).sorted().toList();
    }
  }

  @ParameterizedTest
  @MethodSource("english")
  void eachTextExistsInBothLanguagesWithTheSamePlaces(Path file) throws IOException {
    Properties english = read(file);
    Properties german = read(file.resolveSibling("messages_de.properties"));

    assertThat(german.stringPropertyNames()).isEqualTo(english.stringPropertyNames());
    for (String key : english.stringPropertyNames()) {
      assertThat(places(german.getProperty(key)))
          .as("%s in %s", key, file)
          .isEqualTo(places(english.getProperty(key)));
    }
  }

  /**
   * There is no number in braces, no doubled quotation mark, and no incomplete format specifier.
   */
  @ParameterizedTest
  @MethodSource("english")
  void placesAreWrittenAsPhrasesHaveThem(Path file) throws IOException {
    for (String name : List.of("messages.properties", "messages_de.properties")) {
      Properties texts = read(file.resolveSibling(name));
      for (String key : texts.stringPropertyNames()) {
        String text = texts.getProperty(key);
        assertThat(text).as("%s in %s", key, file).doesNotContainPattern("\\{\\d|''");
        String rest = PLACE.matcher(text).replaceAll("").replace("%%", "");
        if (!rest.equals(text)) {
          assertThat(rest).as("%s in %s", key, file).doesNotContain("%");
        }
      }
    }
  }

  /** Returns the format specifiers of a text, such as {@code 1s}. */
  private static Set<String> places(String text) {
    Set<String> places = new TreeSet<>();
    Matcher matcher = PLACE.matcher(text);
    for (int next = 1; matcher.find(); ) {
      String number = matcher.group(1) == null ? next++ + "" : matcher.group(1).replace("$", "");
      places.add(number + matcher.group().replaceAll("%(\\d\\$)?", ""));
    }
    return places;
  }

  private static Properties read(Path file) throws IOException {
    Properties texts = new Properties();
    try (Reader reader = Files.newBufferedReader(file)) {
      texts.load(reader);
    }
    return texts;
  }
}
