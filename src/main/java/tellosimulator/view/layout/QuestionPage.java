package tellosimulator.view.layout;

import java.util.List;
import javafx.scene.control.Label;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;

/** A question with a button for each answer. For the JavaFX thread. */
public final class QuestionPage extends Page {

  /**
   * @param close lets go of the page
   */
  QuestionPage(ViewContext context, Question question, Runnable close) {
    super(
        "question-page",
        "question-page",
        context.language().messages(QuestionPage.class).text(question.key(), question.subject()));
    Messages messages = context.language().messages(QuestionPage.class);
    setMaxHeight(USE_PREF_SIZE);
    Label text = new Label();
    text.textProperty().bind(messages.text(question.key() + "-text", question.subject()));
    text.setWrapText(true);
    for (Question.Answer answer : question.answers()) {
      addButton(answer.key(), messages.text(answer.key()))
          .setOnAction(
              pressed -> {
                close.run();
                answer.action().run();
              });
    }
    layoutPage(text);
  }

  /**
   * Something to be decided before it goes on. Each answer closes it; so does Esc, which does
   * nothing else.
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
}
