package tellosimulator.view.controls;

import java.util.Optional;
import javafx.scene.control.Label;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.text.Message;
import tellosimulator.view.text.Messages;

/**
 * A label for a message about the control above it; it takes no space while there is no message.
 */
final class MessageLabel extends Label {

  private final Messages messages;
  private Optional<Message> said = Optional.empty();

  /**
   * @param styleClass {@code danger} or {@code warning}
   */
  public MessageLabel(Messages messages, String id, String styleClass) {
    this.messages = messages;
    Nodes.wrapping(Nodes.named(this, id, "sentence", styleClass));
    setMaxWidth(Double.MAX_VALUE);
    Nodes.showIf(this, textProperty().isNotEmpty());
  }

  /** Shows a message, or hides the label. */
  void say(Optional<Message> problem) {
    if (problem.equals(said)) {
      return;
    }
    said = problem;
    textProperty().unbind();
    problem.ifPresentOrElse(what -> textProperty().bind(what.text(messages)), () -> setText(""));
  }
}
