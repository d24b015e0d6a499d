package tellosimulator.view.log;

import javafx.beans.value.ObservableBooleanValue;
import javafx.css.PseudoClass;
import javafx.scene.control.Label;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.view.fx.Tooltips;

/**
 * Shows a row of the log in one line: level, time, drone, and what happened; of a command its
 * reply, how long it took, and why it was refused. What is cut off is whole in its tooltip. For the
 * JavaFX thread.
 */
final class LogRowView extends HBox {

  private static final double TOOLTIP_WIDTH = 800;

  private static final PseudoClass COMMAND = PseudoClass.getPseudoClass("command");

  private final LogFormat text;
  private final FontIcon icon = new FontIcon();
  private final Label time = new Label();
  private final Label drone = new Label();
  private final Label words = new Label();
  private final Label reply = new Label();
  private final Label duration = new Label();
  private final Label reason = new Label();
  private final Tooltip whole = new Tooltip();

  /**
   * @param timeStamps whether it shows when that was
   */
  LogRowView(LogFormat text, ObservableBooleanValue timeStamps) {
    this.text = text;
    whole.setWrapText(true);
    whole.setMaxWidth(TOOLTIP_WIDTH);
    time.getStyleClass().add("log-time");
    Tooltips.install(time, text.timeHint());
    drone.getStyleClass().add("log-drone");
    drone.setMinWidth(USE_PREF_SIZE);
    words.getStyleClass().add("log-words");
    reply.getStyleClass().add("log-reply");
    duration.getStyleClass().add("log-duration");
    reason.getStyleClass().add("log-reason");
    for (Label growing : new Label[] {words, reason}) {
      HBox.setHgrow(growing, Priority.ALWAYS);
      growing.setMaxWidth(Double.MAX_VALUE);
      growing.setMinWidth(0);
      growing.setOnMouseEntered(entered -> offerTooltip(growing));
    }
    reply.setOnMouseEntered(entered -> offerTooltip(reply));
    getChildren().addAll(icon, time, drone, words, reply, duration, reason);
    time.visibleProperty().bind(timeStamps);
    time.managedProperty().bind(timeStamps);
    drone.managedProperty().bind(drone.textProperty().isNotEmpty());
  }

  private void offerTooltip(Label label) {
    boolean cutOff = label.prefWidth(-1) > label.getWidth();
    whole.setText(label.getText());
    label.setTooltip(cutOff ? whole : null);
  }

  /** Shows a row. */
  void show(LogRow row) {
    boolean command = row.command().isPresent();
    getStyleClass().setAll("log-line", "log-" + row.level().key());
    pseudoClassStateChanged(COMMAND, command);
    icon.setIconCode(row.level().icon());
    time.setText(text.time(row.first()));
    drone.setText(text.drone(row.first()));
    words.setText(text.words(row));
    reply.setText(text.reply(row));
    duration.setText(text.duration(row));
    reason.setText(text.reason(row));
    for (Label part : new Label[] {reply, duration, reason}) {
      part.setVisible(command);
      part.setManaged(command);
    }
  }
}
