package tellosimulator.view.log;

import java.util.Optional;
import javafx.beans.property.SimpleObjectProperty;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.ContentDisplay;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.text.Messages;

/**
 * The folded log: its newest row, the report of the last flight, and a button that unfolds it. For
 * the JavaFX thread.
 */
final class FoldedLog extends HBox {

  private final Button button = new Button("", new FontIcon(Feather.CHEVRON_UP));
  private final LogRowView row;
  private final ReportButton report;

  /**
   * @param row shows the newest row
   * @param unfold shows the whole log
   */
  FoldedLog(Messages messages, LogRowView row, Runnable unfold) {
    this.row = row;
    report =
        new ReportButton(
            messages, "folded-report", new SimpleObjectProperty<>(ContentDisplay.LEFT));
    button.setId("log-unfold");
    Tooltips.install(button, messages.text("unfold.tooltip"));
    button.accessibleTextProperty().bind(messages.text("unfold.tooltip"));
    button.setOnAction(pressed -> unfold.run());
    button.setMinWidth(USE_PREF_SIZE);
    getStyleClass().addAll("log-toolbar", "log-folded");
    setAlignment(Pos.CENTER_LEFT);
    setHgrow(row, Priority.ALWAYS);
    row.setMinWidth(0);
    getChildren().addAll(messages.label("title", "log-title"), row, report, button);
  }

  /** Lets one open the report of the last flight, from now on. */
  void offer(ReportOffer offer) {
    report.offer(offer);
  }

  /** Unfolds it. */
  Button button() {
    return button;
  }

  /** Shows the newest row, if there is one. */
  void show(Optional<LogRow> newest) {
    newest.ifPresent(row::show);
    row.setVisible(newest.isPresent());
  }
}
