package tellosimulator.view.log;

import javafx.beans.value.ObservableBooleanValue;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import org.kordamp.ikonli.javafx.FontIcon;

/** Shows one line: level, time, drone, words. A line that is cut off is whole in its tooltip. */
final class LogCell extends ListCell<LogLine> {

  private static final double TOOLTIP_WIDTH = 800;

  private final LogFormat text;
  private final ObservableBooleanValue timeStamps;
  private final FontIcon icon = new FontIcon();
  private final Label time = new Label();
  private final Label drone = new Label();
  private final Label words = new Label();
  private final HBox parts = new HBox(icon, time, drone, words);
  private final Tooltip whole = new Tooltip();

  LogCell(LogFormat text, ObservableBooleanValue timeStamps) {
    this.text = text;
    this.timeStamps = timeStamps;
    initializeSelf();
    layoutParts();
    setupEventHandlers();
    setupBindings();
  }

  private void initializeSelf() {
    setPrefWidth(0); // as wide as the list, never wider
    setText(null);
    whole.setWrapText(true);
    whole.setMaxWidth(TOOLTIP_WIDTH);
    parts.getStyleClass().add("log-line");
    time.getStyleClass().add("log-time");
    drone.getStyleClass().add("log-drone");
    drone.setMinWidth(USE_PREF_SIZE);
    words.getStyleClass().add("log-words");
  }

  private void layoutParts() {
    HBox.setHgrow(words, Priority.ALWAYS);
    words.setMaxWidth(Double.MAX_VALUE);
    words.setMinWidth(0);
  }

  private void setupEventHandlers() {
    words.setOnMouseEntered(entered -> offerTooltip());
  }

  private void setupBindings() {
    time.visibleProperty().bind(timeStamps);
    time.managedProperty().bind(timeStamps);
    drone.managedProperty().bind(drone.textProperty().isNotEmpty());
  }

  private void offerTooltip() {
    boolean cutOff = words.prefWidth(-1) > words.getWidth();
    whole.setText(words.getText());
    words.setTooltip(cutOff ? whole : null);
  }

  @Override
  protected void updateItem(LogLine line, boolean empty) {
    super.updateItem(line, empty);
    if (empty || line == null) {
      setGraphic(null);
      return;
    }
    parts.getStyleClass().setAll("log-line", "log-" + line.level().key());
    icon.setIconCode(line.level().icon());
    time.setText(text.time(line));
    drone.setText(text.drone(line));
    words.setText(text.words(line));
    setGraphic(parts);
  }
}
