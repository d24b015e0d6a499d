package tellosimulator.view.controls;

import atlantafx.base.theme.Styles;
import javafx.scene.control.Label;
import javafx.scene.layout.VBox;
import tellosimulator.view.model.ViewContext;

/**
 * The selected drone's power switch, with a sentence if one of its ports cannot be had. For the
 * JavaFX thread.
 */
final class PowerPanel extends VBox {

  private final PowerSwitch power;

  PowerPanel(ViewContext context) {
    power = new PowerSwitch(context, "power");
    power.setMaxWidth(Double.MAX_VALUE);
    Label problem = new Label();
    problem.setId("power-error");
    problem.getStyleClass().addAll("sentence", Styles.DANGER);
    problem.setWrapText(true);
    problem.setMaxWidth(Double.MAX_VALUE);
    problem.setMinHeight(USE_PREF_SIZE);
    problem.textProperty().bind(power.problemProperty());
    problem.visibleProperty().bind(problem.textProperty().isNotEmpty());
    problem.managedProperty().bind(problem.visibleProperty());
    getStyleClass().add("power-panel");
    getChildren().addAll(power, problem);
  }

  /** Whatever was wrong with the ports, they are others now. */
  void forgetError() {
    power.forgetProblem();
  }
}
