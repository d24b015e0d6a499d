package tellosimulator.view.fx;

import javafx.beans.value.ObservableValue;
import javafx.scene.Node;
import javafx.scene.control.Control;
import javafx.scene.control.Tooltip;
import javafx.util.Duration;

/** Tooltips that follow the language. For the JavaFX thread. */
public final class Tooltips {

  /** Until one appears. Decided: half of the toolkit's, so that people find it. */
  private static final Duration DELAY = Duration.millis(500);

  private static final double WIDTH = 300;

  private Tooltips() {}

  /** Gives a node a tooltip. */
  public static void install(Node node, ObservableValue<String> text) {
    Tooltip tooltip = new Tooltip();
    tooltip.textProperty().bind(text);
    tooltip.setShowDelay(DELAY);
    tooltip.setWrapText(true);
    tooltip.setMaxWidth(WIDTH);
    if (node instanceof Control control) {
      control.setTooltip(tooltip);
    } else {
      Tooltip.install(node, tooltip);
    }
  }
}
