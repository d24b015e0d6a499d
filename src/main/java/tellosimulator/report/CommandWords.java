package tellosimulator.report;

import java.util.Arrays;
import java.util.MissingFormatArgumentException;
import java.util.Optional;

/**
 * Says in plain words what a command asks for: {@code forward 50} is "fly 50 cm forward". The words
 * are texts of the report, {@code command.forward} and so on. For any thread.
 */
record CommandWords(ReportTexts texts) {

  /** What a command asks for; empty if it is none, or has not the values for it. */
  String of(String command) {
    String[] words = command.split(" ", -1);
    return sentence(words, 2).or(() -> sentence(words, 1)).orElse("");
  }

  /**
   * @param verb how many words are the command's name
   */
  private Optional<String> sentence(String[] words, int verb) {
    if (words.length < verb) {
      return Optional.empty();
    }
    String key = "command." + String.join("-", Arrays.copyOf(words, verb));
    Object[] values = Arrays.copyOfRange(words, verb, words.length);
    // with more values it may be another command of the same name: go x y z speed mid
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
