package tellosimulator.view.log;

import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.text.Messages;

/** The folded log: its newest row, and a button that unfolds it. For the JavaFX thread. */
final class FoldedLog extends HBox {

  private final Button button = new Button("", new FontIcon(Feather.CHEVRON_UP));
  private final LogRowView row;

  /**
   * @param row shows the newest one
   * @param unfold shows the whole log
   */
  FoldedLog(Messages messages, LogRowView row, Runnable unfold) {
    this.row = row;
    button.setId("log-unfold");
    Tooltips.install(button, messages.text("unfold.tooltip"));
    button.accessibleTextProperty().bind(messages.text("unfold.tooltip"));
    button.setOnAction(pressed -> unfold.run());
    button.setMinWidth(USE_PREF_SIZE);
    getStyleClass().addAll("log-toolbar", "log-folded");
    setAlignment(Pos.CENTER_LEFT);
    setHgrow(row, Priority.ALWAYS);
    row.setMinWidth(0);
    getChildren().addAll(messages.label("title", "log-title"), row, button);
  }

  /** Unfolds it. */
  Button button() {
    return button;
  }

  /** Shows the newest row. */
  void show(LogRow newest) {
    row.show(newest);
  }
}
