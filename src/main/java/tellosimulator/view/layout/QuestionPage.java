package tellosimulator.view.layout;

import java.util.List;
import javafx.scene.control.Label;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;

/** A question with a button for each answer. Confined to the JavaFX thread. */
public final class QuestionPage extends Page {

  /**
   * @param close closes the page
   */
  QuestionPage(ViewContext context, Question question, Runnable close) {
    super(
        "question-page",
        context.language().messages(QuestionPage.class).text(question.key(), question.subject()));
    Messages messages = context.language().messages(QuestionPage.class);
    setMaxHeight(USE_PREF_SIZE);
    Label text = Nodes.label(messages.text(question.key() + "-text", question.subject()));
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
   * A question to the user. Each answer closes the page; Esc closes it without any action.
   *
   * @param key the key of the title in this package's messages; the key of the text has the suffix
   *     {@code -text}
   * @param subject the subject of the question, inserted into the texts
   * @param answers the answers; the first one is the default
   */
  public record Question(String key, String subject, List<Answer> answers) {

    /**
     * An answer.
     *
     * @param key the key of its text, and the id of its button
     * @param action the action to run
     */
    public record Answer(String key, Runnable action) {}

    public Question {
      answers = List.copyOf(answers);
    }
  }
}
