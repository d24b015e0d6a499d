package tellosimulator.scenario;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * A line of text for users, in one or more languages. Immutable.
 *
 * @param lines the lines by ISO 639 language code ({@code de}), in the order in which they were
 *     written; a line for all languages has the empty key
 */
public record LocalizedText(Map<String, String> lines) {

  public static final LocalizedText NONE = new LocalizedText(Map.of());

  /** The key of a line for all languages. */
  private static final String ANY = "";

  public LocalizedText {
    lines = Collections.unmodifiableMap(new LinkedHashMap<>(lines));
  }

  /** Creates a text for all languages; an empty line gives an empty text. */
  public static LocalizedText of(String line) {
    return line.isEmpty() ? NONE : new LocalizedText(Map.of(ANY, line));
  }

  public boolean isEmpty() {
    return lines.isEmpty();
  }

  /** The line for all languages, if there is one. */
  Optional<String> only() {
    return Optional.ofNullable(lines.get(ANY));
  }

  /**
   * Returns the line in a language. If there is none, returns the English line, or else the first
   * one. Returns an empty string if the text has no lines.
   */
  public String in(Locale locale) {
    return Optional.ofNullable(lines.get(locale.getLanguage()))
        .or(() -> Optional.ofNullable(lines.get(Locale.ENGLISH.getLanguage())))
        .or(() -> lines.values().stream().findFirst())
        .orElse("");
  }

  /**
   * Returns the English line. If there is none, returns the first one, or an empty string if the
   * text has no lines.
   */
  public String english() {
    return in(Locale.ENGLISH);
  }
}
