package tellosimulator.scenario;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * A line for people, in one language or several. Immutable; for any thread.
 *
 * @param lines by language, as ISO 639 abbreviates it ({@code de}), in the order in which they were
 *     written; a line that is the same in all languages has the empty key
 */
public record LocalizedText(Map<String, String> lines) {

  /** No text. */
  public static final LocalizedText NONE = new LocalizedText(Map.of());

  /** The key of a line that is the same in all languages. */
  private static final String ANY = "";

  public LocalizedText {
    lines = Collections.unmodifiableMap(new LinkedHashMap<>(lines));
  }

  /** A line that is the same in all languages; none if it is empty. */
  public static LocalizedText of(String line) {
    return line.isEmpty() ? NONE : new LocalizedText(Map.of(ANY, line));
  }

  public boolean isEmpty() {
    return lines.isEmpty();
  }

  /** The line, if it is the same in all languages. */
  Optional<String> only() {
    return Optional.ofNullable(lines.get(ANY));
  }

  /** The line in a language, or else in English, or else the first one; empty if there is none. */
  public String in(Locale locale) {
    return Optional.ofNullable(lines.get(locale.getLanguage()))
        .or(() -> Optional.ofNullable(lines.get(Locale.ENGLISH.getLanguage())))
        .or(() -> lines.values().stream().findFirst())
        .orElse("");
  }

  /** In English, or else as {@link #in} says. */
  public String english() {
    return in(Locale.ENGLISH);
  }
}
