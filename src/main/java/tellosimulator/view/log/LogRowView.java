package tellosimulator.view.log;

import javafx.beans.value.ObservableBooleanValue;
import javafx.css.PseudoClass;
import javafx.scene.control.Label;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.fx.Tooltips;

/**
 * Shows a row of the log in one line: level, time, drone and words. For a command, it also shows
 * the reply, the duration, and the reason for a refusal or failure. Tooltips show truncated texts
 * in full. Confined to the JavaFX thread.
 */
final class LogRowView extends HBox {

  private static final double TOOLTIP_WIDTH = 800;

  private static final PseudoClass COMMAND = PseudoClass.getPseudoClass("command");

  private final LogFormat text;
  private final FontIcon icon = new FontIcon();
  private final Label time = Nodes.styled(new Label(), "log-time");
  private final Label drone = Nodes.styled(new Label(), "log-drone");
  private final Label words = Nodes.styled(new Label(), "log-words");
  private final Label reply = Nodes.styled(new Label(), "log-reply");
  private final Label duration = Nodes.styled(new Label(), "log-duration");
  private final Label reason = Nodes.styled(new Label(), "log-reason");
  private final Tooltip whole = new Tooltip();

  /**
   * @param timeStamps whether the time is shown
   */
  LogRowView(LogFormat text, ObservableBooleanValue timeStamps) {
    this.text = text;
    whole.setWrapText(true);
    whole.setMaxWidth(TOOLTIP_WIDTH);
    Tooltips.install(time, text.timeHint());
    drone.setMinWidth(USE_PREF_SIZE);
    for (Label growing : new Label[] {words, reason}) {
      Nodes.growing(growing);
      growing.setMinWidth(0);
      growing.setOnMouseEntered(entered -> offerTooltip(growing));
    }
    reply.setOnMouseEntered(entered -> offerTooltip(reply));
    getChildren().addAll(icon, time, drone, words, reply, duration, reason);
    Nodes.showIf(time, timeStamps);
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
      Nodes.setShown(part, command);
    }
  }
}
