package tellosimulator.words;

import java.util.List;
import java.util.Locale;

/**
 * A translatable message: a clause, or a part of a clause. A phrase is formatted when its text is
 * requested, not when it is created. Immutable.
 *
 * @param template the English text, with format specifiers as in {@link java.util.Formatter}; taken
 *     literally if there are no values
 * @param values numbers, texts that are the same in all languages, and phrases
 */
public record Phrase(String template, List<Object> values) {

  public Phrase {
    values = List.copyOf(values);
  }

  /**
   * Creates a phrase.
   *
   * @param template the English text; must be a string literal, because a test collects the
   *     templates from the source code
   */
  public static Phrase of(String template, Object... values) {
    return new Phrase(template, List.of(values));
  }

  /**
   * Creates a phrase from a name, for example the name of an obstacle. Names that come with the
   * program have translations; others are used unchanged.
   */
  public static Phrase name(String name) {
    return new Phrase(name, List.of());
  }

  /** Formats the phrase in English. */
  public String english() {
    return in(Translation.ENGLISH);
  }

  /** Formats the phrase in a language. */
  public String in(Translation translation) {
    Object[] said = values.toArray();
    for (int i = 0; i < said.length; i++) {
      if (said[i] instanceof Phrase part) {
        said[i] = part.in(translation);
      }
    }
    return format(translation.locale(), translation.of(template), said);
  }

  /** Formats a template with values. Without values, the template is taken literally. */
  public static String format(Locale locale, String template, Object... values) {
    return values.length == 0 ? template : String.format(locale, template, values);
  }

  /** Returns the phrase in English. */
  @Override
  public String toString() {
    return english();
  }
}
