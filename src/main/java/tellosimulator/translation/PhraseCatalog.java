package tellosimulator.translation;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import tellosimulator.words.Translation;

/**
 * The phrases of the simulation in another language. What is missing stays English. Immutable; for
 * any thread.
 *
 * <p>A glossary is written in pairs of lines: {@code en:} and the English template, then the
 * language's code, a colon and the translation. Empty lines and those that begin with {@code #} say
 * nothing.
 */
public final class PhraseCatalog implements Translation {

  /** The languages that there are texts in, the fallback first. */
  public static final List<Locale> OFFERED = List.of(Locale.ENGLISH, Locale.GERMAN);

  private static final String ENGLISH_MARK = "en: ";

  private final Locale locale;
  private final Map<String, String> translations;

  private PhraseCatalog(Locale locale, Map<String, String> translations) {
    this.locale = locale;
    this.translations = Map.copyOf(translations);
  }

  /** Of the offered languages the one that a person with this locale reads, English for others. */
  public static Locale nearest(Locale wanted) {
    return OFFERED.stream()
        .filter(offered -> offered.getLanguage().equals(wanted.getLanguage()))
        .findFirst()
        .orElse(Locale.ENGLISH);
  }

  /** The translation for a person with this locale. */
  public static Translation of(Locale wanted) {
    Locale locale = nearest(wanted);
    if (locale.equals(Locale.ENGLISH)) {
      return Translation.ENGLISH;
    }
    String name = "phrases_" + locale.getLanguage() + ".txt";
    try (InputStream file = PhraseCatalog.class.getResourceAsStream(name)) {
      return read(new InputStreamReader(file, StandardCharsets.UTF_8), locale);
    } catch (IOException e) {
      throw new UncheckedIOException(name + " cannot be read", e);
    }
  }

  /**
   * Reads a glossary.
   *
   * @throws IllegalArgumentException naming the line that is no part of a pair, or what is
   *     translated twice
   */
  static PhraseCatalog read(Reader source, Locale locale) {
    List<String> lines =
        new BufferedReader(source)
            .lines()
            .filter(line -> !line.isEmpty() && !line.startsWith("#"))
            .toList();
    Map<String, String> translations = new HashMap<>();
    for (int i = 0; i < lines.size(); i += 2) {
      String english = after(ENGLISH_MARK, lines.get(i));
      String next = i + 1 < lines.size() ? lines.get(i + 1) : "nothing";
      String translation = after(locale.getLanguage() + ": ", next);
      if (translations.put(english, translation) != null) {
        throw new IllegalArgumentException("\"" + english + "\" is translated twice");
      }
    }
    return new PhraseCatalog(locale, translations);
  }

  private static String after(String mark, String line) {
    if (!line.startsWith(mark)) {
      throw new IllegalArgumentException("expected \"" + mark + "\", found \"" + line + "\"");
    }
    return line.substring(mark.length());
  }

  /** What is translated, with its translation. */
  Map<String, String> translations() {
    return translations;
  }

  @Override
  public String of(String template) {
    return translations.getOrDefault(template, template);
  }

  @Override
  public Set<String> templates() {
    return translations.keySet();
  }

  @Override
  public Locale locale() {
    return locale;
  }
}
