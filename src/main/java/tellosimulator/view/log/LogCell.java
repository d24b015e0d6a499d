package tellosimulator.view.log;

import javafx.beans.value.ObservableBooleanValue;
import javafx.scene.control.ListCell;

/** Shows a row in the list of the log. For the JavaFX thread. */
final class LogCell extends ListCell<LogRow> {

  private final LogFormat text;
  private final LogRowView view;

  LogCell(LogFormat text, ObservableBooleanValue timeStamps) {
    this.text = text;
    this.view = new LogRowView(text, timeStamps);
    setPrefWidth(0); // as wide as the list, never wider
    setText(null);
  }

  @Override
  protected void updateItem(LogRow row, boolean empty) {
    super.updateItem(row, empty);
    if (empty || row == null) {
      setGraphic(null);
      setAccessibleText(null);
      return;
    }
    view.show(row);
    setGraphic(view);
    setAccessibleText(text.spoken(row));
  }
}
