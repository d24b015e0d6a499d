package tellosimulator.view.log;

import atlantafx.base.theme.Styles;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.Button;
import javafx.scene.control.ContentDisplay;
import javafx.scene.layout.HBox;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.log.ReportOffer.Availability;
import tellosimulator.view.text.Messages;

/**
 * Opens the report of the last flight, or says why there is none; it takes no room until reports
 * are offered. In a frame, for a button that is disabled would show no tooltip itself. For the
 * JavaFX thread.
 */
final class ReportButton extends HBox {

  private final Messages messages;
  private final Button button = new Button(null, new FontIcon(Feather.FILE_TEXT));

  /**
   * @param display whether there is room for a word beside the icon
   */
  ReportButton(Messages messages, String id, ObservableValue<ContentDisplay> display) {
    this.messages = messages;
    button.setId(id);
    button.getStyleClass().addAll(Styles.SMALL);
    button.textProperty().bind(messages.text("report"));
    button.contentDisplayProperty().bind(display);
    button.setMinWidth(USE_PREF_SIZE);
    getChildren().add(button);
    setVisible(false);
    managedProperty().bind(visibleProperty());
  }

  /** Lets one open reports, from now on. */
  void offer(ReportOffer offer) {
    button.setOnAction(action -> offer.open());
    ObservableValue<Availability> availability = offer.availabilityProperty();
    button.disableProperty().bind(availability.map(now -> now != Availability.READY));
    Tooltips.install(this, availability.flatMap(now -> messages.text("report." + now.key())));
    setVisible(true);
  }
}
