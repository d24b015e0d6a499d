package tellosimulator.testing;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * A page of {@code docs} that is generated from the code and a template. A test compares it with
 * the file, and writes the file with {@code -Dupdate.docs=true}.
 *
 * @param name of the file in {@code docs}, without its extension
 */
public record GeneratedPage(String name) {

  /** Returns the template, in which the generated parts have names in double braces. */
  public String template() {
    return read(Path.of("src", "test", "resources", "docs", name + ".template.md"));
  }

  /**
   * Fails unless the file equals a text.
   *
   * @param test the test that generates the text, for the message
   */
  public void check(String text, Class<?> test) {
    Path file = Path.of("docs", name + ".md");
    if (Boolean.getBoolean("update.docs")) {
      write(file, text);
    }
    assertThat(read(file))
        .as(
            "%s is stale; renew it with: mvn test -Dtest=%s -Dupdate.docs=true",
            file, test.getSimpleName())
        .isEqualTo(text);
  }

  private static String read(Path file) {
    try {
      return String.join("\n", Files.readAllLines(file)) + "\n";
    } catch (IOException e) {
      throw new UncheckedIOException("cannot read " + file, e);
    }
  }

  private static void write(Path file, String text) {
    try {
      Files.writeString(file, text);
    } catch (IOException e) {
      throw new UncheckedIOException("cannot write " + file, e);
    }
  }
}
