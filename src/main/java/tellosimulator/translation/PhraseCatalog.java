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
import tellosimulator.words.Translation;

/**
 * The phrases of the simulation in another language. Phrases without a translation stay in English.
 * Immutable.
 *
 * <p>A glossary consists of pairs of lines: {@code en:} and the English template, then the
 * language's code, a colon and the translation. Empty lines and lines that begin with {@code #} are
 * ignored.
 */
public final class PhraseCatalog implements Translation {

  /** The languages offered to users; the first one is the fallback. */
  public static final List<Locale> OFFERED = List.of(Locale.ENGLISH, Locale.GERMAN);

  private static final String ENGLISH_MARK = "en: ";

  private final Locale locale;
  private final Map<String, String> translations;

  private PhraseCatalog(Locale locale, Map<String, String> translations) {
    this.locale = locale;
    this.translations = Map.copyOf(translations);
  }

  /** Returns the offered language that matches a locale; English if none does. */
  public static Locale nearest(Locale wanted) {
    return OFFERED.stream()
        .filter(offered -> offered.getLanguage().equals(wanted.getLanguage()))
        .findFirst()
        .orElse(Locale.ENGLISH);
  }

  /** Returns the phrases in the offered language that matches a locale; English if none does. */
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
   * @throws IllegalArgumentException if a line is not part of a pair, or a text is translated
   *     twice; the message contains the line or text
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

  /** Returns the translations by template. */
  Map<String, String> translations() {
    return translations;
  }

  @Override
  public String of(String template) {
    return translations.getOrDefault(template, template);
  }

  @Override
  public Locale locale() {
    return locale;
  }
}
