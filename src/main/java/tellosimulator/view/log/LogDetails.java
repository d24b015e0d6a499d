package tellosimulator.view.log;

import java.util.Optional;
import java.util.OptionalLong;
import javafx.scene.control.TextArea;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.text.Messages;

/**
 * A text area next to the list that shows all lines of one row, so that they can be read and
 * copied. Invisible while no row is open. Confined to the JavaFX thread.
 */
final class LogDetails extends TextArea {

  private final LogFormat text;
  private final LogModel model;
  private OptionalLong opened = OptionalLong.empty();

  LogDetails(LogFormat text, LogModel model, Messages messages) {
    this.text = text;
    this.model = model;
    Nodes.named(this, "log-details", "log-details");
    setEditable(false);
    setWrapText(true);
    accessibleTextProperty().bind(messages.text("details"));
    close();
  }

  boolean isOpen() {
    return opened.isPresent();
  }

  /** Opens a row, or closes it if it is already open. */
  void toggle(LogRow row) {
    if (opened.equals(OptionalLong.of(row.number()))) {
      close();
    } else {
      open(row);
    }
  }

  void open(LogRow row) {
    opened = OptionalLong.of(row.number());
    Nodes.setShown(this, true);
    refresh();
  }

  void close() {
    opened = OptionalLong.empty();
    Nodes.setShown(this, false);
  }

  /**
   * Updates the text with new lines of the open row, or closes the row if it has been removed from
   * the log.
   */
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
