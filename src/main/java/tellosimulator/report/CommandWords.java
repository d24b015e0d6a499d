package tellosimulator.report;

import java.util.Arrays;
import java.util.MissingFormatArgumentException;
import java.util.Optional;

/**
 * Describes commands in plain words: {@code forward 50} becomes "fly 50 cm forward". The words are
 * report texts named {@code command.forward} and so on. Thread-safe.
 */
record CommandWords(ReportTexts texts) {

  /** Describes a command; empty if the command is unknown or lacks values. */
  String of(String command) {
    String[] words = command.split(" ", -1);
    return sentence(words, 2).or(() -> sentence(words, 1)).orElse("");
  }

  /**
   * Builds the description.
   *
   * @param verb the number of words in the command's name
   */
  private Optional<String> sentence(String[] words, int verb) {
    if (words.length < verb) {
      return Optional.empty();
    }
    String key = "command." + String.join("-", Arrays.copyOf(words, verb));
    Object[] values = Arrays.copyOfRange(words, verb, words.length);
    // the number of values may select another command: go x y z speed mid
    return texts
        .template(key + "." + values.length)
        .or(() -> texts.template(key))
        .flatMap(template -> said(template, values));
  }

  private Optional<String> said(String template, Object[] values) {
    try {
      return Optional.of(String.format(texts.locale(), template, values));
    } catch (MissingFormatArgumentException e) {
      return Optional.empty();
    }
  }
}
