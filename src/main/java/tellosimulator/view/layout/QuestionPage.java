package tellosimulator.view.layout;

import atlantafx.base.theme.Styles;
import java.util.ArrayList;
import java.util.List;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.VBox;
import tellosimulator.view.ViewContext;
import tellosimulator.view.text.Messages;

/** A question with a button for each answer. For the JavaFX thread. */
final class QuestionPage extends VBox {

  private final List<Button> buttons = new ArrayList<>();

  /**
   * @param close lets go of the page
   */
  QuestionPage(ViewContext context, Question question, Runnable close) {
    Messages messages = context.language().messages(QuestionPage.class);
    setId("question-page");
    setMaxHeight(USE_PREF_SIZE);
    getStyleClass().addAll("page", "mistakes-page");
    getStylesheets().add(QuestionPage.class.getResource("pages.css").toExternalForm());
    Label title = new Label();
    title.textProperty().bind(messages.text(question.key(), question.subject()));
    title.getStyleClass().add(Styles.TITLE_3);
    title.setWrapText(true);
    Label text = new Label();
    text.textProperty().bind(messages.text(question.key() + "-text", question.subject()));
    text.setWrapText(true);
    for (Question.Answer answer : question.answers()) {
      Button button = new Button();
      button.setId(answer.key());
      button.textProperty().bind(messages.text(answer.key()));
      button.setDefaultButton(buttons.isEmpty());
      button.setOnAction(
          pressed -> {
            close.run();
            answer.action().run();
          });
      buttons.add(button);
    }
    HBox row = new HBox();
    row.getStyleClass().add("page-buttons");
    row.getChildren().addAll(buttons);
    getChildren().addAll(title, text, row);
  }

  Button usualButton() {
    return buttons.get(0);
  }
}
