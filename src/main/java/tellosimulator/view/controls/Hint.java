package tellosimulator.view.controls;

import javafx.beans.value.ObservableValue;
import javafx.scene.Node;
import javafx.scene.control.Tooltip;
import javafx.util.Duration;

/** What a control says about itself when the mouse rests on it. */
final class Hint {

  /** Until it appears [ms]. Decided: half of the toolkit's, so that people find it. */
  private static final double DELAY_MS = 500;

  private Hint() {}

  static void on(Node node, ObservableValue<String> text) {
    Tooltip tooltip = new Tooltip();
    tooltip.textProperty().bind(text);
    tooltip.setShowDelay(Duration.millis(DELAY_MS));
    tooltip.setWrapText(true);
    tooltip.setMaxWidth(300);
    Tooltip.install(node, tooltip);
  }
}
