package tellosimulator.testing;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.regex.Pattern;

/** Checks texts for names of classes, records and Java objects, which messages must not contain. */
public final class ForPeople {

  private static final Pattern JAVA =
      Pattern.compile(
          "\\b(java|javax|com\\.sun|org|picocli|tellosimulator)\\.[a-z]|Exception|Throwable|[a-z]Error\\b"
              + "|[A-Za-z][\\[{][a-z]\\w*=|\\w@[0-9a-f]{4,}|\\bOptional[.\\[]|\\bnull\\b|\\$\\d|\\.java\\b");

  private ForPeople() {}

  /** Fails if a text contains such a name. */
  public static void check(String text) {
    assertThat(text).doesNotContainPattern(JAVA);
  }
}
