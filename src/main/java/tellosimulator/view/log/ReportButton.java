package tellosimulator.view.log;

import atlantafx.base.theme.Styles;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.Button;
import javafx.scene.control.ContentDisplay;
import javafx.scene.layout.HBox;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.log.ReportOffer.Availability;
import tellosimulator.view.text.Messages;

/**
 * The button that opens the report of the last flight. If there is no report, the tooltip explains
 * why. The button takes no space until {@link #offer} is called. It is wrapped in a frame, because
 * a disabled button does not show a tooltip. Confined to the JavaFX thread.
 */
final class ReportButton extends HBox {

  private final Messages messages;
  private final Button button = new Button(null, new FontIcon(Feather.FILE_TEXT));

  /**
   * @param display whether the button has a label beside its icon
   */
  ReportButton(Messages messages, String id, ObservableValue<ContentDisplay> display) {
    this.messages = messages;
    Nodes.named(Nodes.unshrinkable(button), id, Styles.SMALL);
    button.textProperty().bind(messages.text("report"));
    button.contentDisplayProperty().bind(display);
    getChildren().add(button);
    Nodes.setShown(this, false);
  }

  /** Shows the button. A click opens the report of the given offer. */
  void offer(ReportOffer offer) {
    button.setOnAction(action -> offer.open());
    ObservableValue<Availability> availability = offer.availabilityProperty();
    button.disableProperty().bind(availability.map(now -> now != Availability.READY));
    Tooltips.install(this, availability.flatMap(now -> messages.text("report." + now.key())));
    Nodes.setShown(this, true);
  }
}
