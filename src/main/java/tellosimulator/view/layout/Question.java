package tellosimulator.view.layout;

import java.util.List;

/**
 * Something to be decided before it goes on. Each answer closes it; so does Esc, which does nothing
 * else.
 *
 * @param key of its title in this package's messages; that of its text ends with {@code -text}
 * @param subject what it is about, for the texts
 * @param answers the first is the usual one
 */
public record Question(String key, String subject, List<Answer> answers) {

  /**
   * An answer.
   *
   * @param key of its text, and id of its button
   * @param action what it does
   */
  public record Answer(String key, Runnable action) {}

  public Question {
    answers = List.copyOf(answers);
  }
}
