package tellosimulator.words;

import java.util.List;
import java.util.Locale;

/**
 * Something to be said to people, in any language: a clause, or a part of one. Immutable; for any
 * thread. It is put into words when it is read, not when it is made.
 *
 * @param template in English, with places for the values as {@link java.util.Formatter} writes
 *     them; without values it is taken literally
 * @param values numbers, texts that are the same in all languages, and phrases
 */
public record Phrase(String template, List<Object> values) {

  public Phrase {
    values = List.copyOf(values);
  }

  /**
   * A phrase.
   *
   * @param template written out at each call, because a test collects the templates from the
   *     sources
   */
  public static Phrase of(String template, Object... values) {
    return new Phrase(template, List.of(values));
  }

  /** A name of something; of those that come with the program there are translations. */
  public static Phrase name(String name) {
    return new Phrase(name, List.of());
  }

  /** Said in English. */
  public String english() {
    return in(Translation.ENGLISH);
  }

  /** Said in a language. */
  public String in(Translation translation) {
    Object[] said = values.toArray();
    for (int i = 0; i < said.length; i++) {
      if (said[i] instanceof Phrase part) {
        said[i] = part.in(translation);
      }
    }
    return format(translation.locale(), translation.of(template), said);
  }

  /** Puts values into the places of a template; without values it is taken literally. */
  public static String format(Locale locale, String template, Object... values) {
    return values.length == 0 ? template : String.format(locale, template, values);
  }

  /** Said in English. */
  @Override
  public String toString() {
    return english();
  }
}
