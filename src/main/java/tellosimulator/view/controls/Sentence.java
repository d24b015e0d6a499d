package tellosimulator.view.controls;

import java.util.Optional;
import javafx.scene.control.Label;
import tellosimulator.view.text.Messages;

/** A sentence below what it is about; it takes no room while there is nothing to say. */
final class Sentence extends Label {

  private final Messages messages;
  private Optional<Complaint> said = Optional.empty();

  /**
   * @param styleClass {@code danger} or {@code warning}
   */
  Sentence(Messages messages, String id, String styleClass) {
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
  void say(Optional<Complaint> complaint) {
    if (complaint.equals(said)) {
      return;
    }
    said = complaint;
    textProperty().unbind();
    complaint.ifPresentOrElse(
        what -> textProperty().bind(what.sentence(messages)), () -> setText(""));
  }
}
