package tellosimulator.view.log;

import java.util.Optional;
import java.util.OptionalLong;
import javafx.scene.control.TextArea;
import tellosimulator.view.text.Messages;

/**
 * All lines of one row, beside the list, as a text that can be read and copied; not there while no
 * row is open. For the JavaFX thread.
 */
final class LogDetails extends TextArea {

  private final LogFormat text;
  private final LogModel model;
  private OptionalLong opened = OptionalLong.empty();

  LogDetails(LogFormat text, LogModel model, Messages messages) {
    this.text = text;
    this.model = model;
    setId("log-details");
    getStyleClass().add("log-details");
    setEditable(false);
    setWrapText(true);
    accessibleTextProperty().bind(messages.text("details"));
    close();
  }

  boolean isOpen() {
    return opened.isPresent();
  }

  /** Opens a row, or closes it if it is open. */
  void toggle(LogRow row) {
    if (opened.equals(OptionalLong.of(row.number()))) {
      close();
    } else {
      open(row);
    }
  }

  void open(LogRow row) {
    opened = OptionalLong.of(row.number());
    setVisible(true);
    setManaged(true);
    refresh();
  }

  void close() {
    opened = OptionalLong.empty();
    setVisible(false);
    setManaged(false);
  }

  /** Takes over what came to the row, which closes if it fell out. */
  void refresh() {
    if (opened.isPresent()) {
      Optional<String> now = model.row(opened.getAsLong()).map(text::details);
      if (now.isEmpty()) {
        close();
      } else if (!now.get().equals(getText())) {
        setText(now.get());
      }
    }
  }
}
