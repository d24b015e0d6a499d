package tellosimulator.view.fx;

import javafx.beans.value.ObservableValue;
import javafx.scene.Node;
import javafx.scene.control.Control;
import javafx.scene.control.Tooltip;
import javafx.util.Duration;

/** Installs tooltips that follow the language. Confined to the JavaFX thread. */
public final class Tooltips {

  /**
   * Delay before a tooltip appears. Decided: half of JavaFX's default, so that users notice that
   * there are tooltips.
   */
  private static final Duration DELAY = Duration.millis(500);

  private static final double WIDTH = 300;

  private Tooltips() {}

  /** Installs a tooltip on a node. */
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
