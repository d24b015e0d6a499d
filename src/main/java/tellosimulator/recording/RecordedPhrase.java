package tellosimulator.recording;

import java.util.ArrayList;
import java.util.IllegalFormatException;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import tellosimulator.words.Phrase;

/**
 * Converts phrases to and from JSON arrays, so that a recording can be shown in a language other
 * than the one in which it was recorded. An array holds the template followed by its values; a
 * value that is itself a phrase is a nested array. Thread-safe.
 */
final class RecordedPhrase {

  /**
   * Matches the placeholders that are accepted in templates. Others are invalid, or could be
   * crafted to exhaust memory.
   */
  private static final Pattern PLACE =
      Pattern.compile("%(?:[1-9]\\$)?(?:s|,?d|,?(?:\\.[0-9])?f)|%%");

  private RecordedPhrase() {}

  /** Converts a phrase to lists, strings and numbers. */
  static List<Object> members(Phrase phrase) {
    List<Object> members = new ArrayList<>();
    members.add(phrase.template());
    for (Object value : phrase.values()) {
      if (value instanceof Phrase part) {
        members.add(members(part));
      } else {
        members.add(value instanceof Number ? value : value.toString());
      }
    }
    return members;
  }

  /**
   * Parses a phrase.
   *
   * @param members the value from a recording, or null
   * @param english text that is used literally if the value is not a phrase
   */
  static Phrase of(Object members, String english) {
    return phrase(members).orElseGet(() -> Phrase.name(english));
  }

  private static Optional<Phrase> phrase(Object members) {
    if (!(members instanceof List<?> list)
        || list.isEmpty()
        || !(list.get(0) instanceof String template)) {
      return Optional.empty();
    }
    List<Object> values = new ArrayList<>();
    for (Object value : list.subList(1, list.size())) {
      Optional<?> read =
          value instanceof String || value instanceof Number ? Optional.of(value) : phrase(value);
      if (read.isEmpty()) {
        return Optional.empty();
      }
      values.add(read.get());
    }
    return Optional.of(new Phrase(template, values)).filter(RecordedPhrase::isComplete);
  }

  /**
   * Returns whether the values fit the template. Without values, every template fits, because it is
   * taken literally.
   */
  private static boolean isComplete(Phrase phrase) {
    if (!phrase.values().isEmpty()
        && PLACE.matcher(phrase.template()).replaceAll("").indexOf('%') >= 0) {
      return false;
    }
    try {
      return phrase.english() != null;
    } catch (IllegalFormatException e) {
      return false;
    }
  }
}
