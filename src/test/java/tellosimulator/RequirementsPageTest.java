package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Checks that everything to which docs/requirements.md refers exists. */
class RequirementsPageTest {

  private static final Path PAGE = Path.of("docs", "requirements.md");
  private static final Pattern NAMED_TEST = Pattern.compile("`(\\w+(?:Test|IT))(?:\\.(\\w+))?`");
  private static final Pattern ROW = Pattern.compile("(?m)^\\| R(\\d+) \\|");
  private static final Pattern PICTURE = Pattern.compile("\\((images/[^)]+)\\)");

  @Test
  void eachNamedTestExists() throws IOException {
    Map<String, String> sources = sources();
    List<MatchResult> named = NAMED_TEST.matcher(Files.readString(PAGE)).results().toList();

    assertThat(named).isNotEmpty();
    for (MatchResult test : named) {
      assertThat(sources.keySet()).contains(test.group(1));
      if (test.group(2) != null) {
        assertThat(sources.get(test.group(1)))
            .containsPattern("  [\\w<>]+ " + test.group(2) + "\\(");
      }
    }
  }

  @Test
  void eachRowOfTheReportIsThere() throws IOException {
    List<Integer> rows =
        ROW.matcher(Files.readString(PAGE))
            .results()
            .map(row -> Integer.valueOf(row.group(1)))
            .toList();

    assertThat(rows)
        .containsExactlyElementsOf(
            Stream.of(
                    IntStream.rangeClosed(1, 14),
                    IntStream.rangeClosed(20, 25),
                    IntStream.rangeClosed(30, 33),
                    IntStream.rangeClosed(40, 41))
                .flatMap(IntStream::boxed)
                .toList());
  }

  @Test
  void eachPictureExists() throws IOException {
    List<String> pictures =
        PICTURE.matcher(Files.readString(PAGE)).results().map(found -> found.group(1)).toList();

    assertThat(pictures).isNotEmpty().allMatch(picture -> Files.exists(Path.of("docs", picture)));
  }

  private static Map<String, String> sources() throws IOException {
    try (Stream<Path> files = Files.walk(Path.of("src"))) {
      return files
          .filter(file -> file.toString().matches(".*(Test|IT)\\.java"))
          .collect(
              Collectors.toMap(
                  file -> file.getFileName().toString().replace(".java", ""),
                  RequirementsPageTest::text));
    }
  }

  private static String text(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }
}
