package tellosimulator.view.controls;

import java.util.Optional;
import javafx.scene.control.Label;
import tellosimulator.view.text.Message;
import tellosimulator.view.text.Messages;

/** A label for a message about the control above it; it takes no room while there is none. */
final class MessageLabel extends Label {

  private final Messages messages;
  private Optional<Message> said = Optional.empty();

  /**
   * @param styleClass {@code danger} or {@code warning}
   */
  public MessageLabel(Messages messages, String id, String styleClass) {
    this.messages = messages;
    setId(id);
    getStyleClass().addAll("sentence", styleClass);
    setWrapText(true);
    setMaxWidth(Double.MAX_VALUE);
    setMinHeight(USE_PREF_SIZE);
    visibleProperty().bind(textProperty().isNotEmpty());
    managedProperty().bind(visibleProperty());
  }

  /** Says it, or nothing. */
  void say(Optional<Message> problem) {
    if (problem.equals(said)) {
      return;
    }
    said = problem;
    textProperty().unbind();
    problem.ifPresentOrElse(what -> textProperty().bind(what.text(messages)), () -> setText(""));
  }
}
