package tellosimulator.view.controls;

import atlantafx.base.theme.Styles;
import java.net.InetSocketAddress;
import java.util.Optional;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.VBox;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.network.PortTakenException;
import tellosimulator.view.FxDroneModel;
import tellosimulator.view.FxSimulation;
import tellosimulator.view.SimulatorActions;
import tellosimulator.view.ViewContext;
import tellosimulator.view.text.Messages;

/**
 * The selected drone's power switch, with a sentence if one of its ports cannot be had. For the
 * JavaFX thread.
 */
final class PowerPanel extends VBox {

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final Messages messages;
  private final ToggleButton power = new ToggleButton();
  private final Sentence error;
  private final ObservableValue<Boolean> on;

  PowerPanel(ViewContext context) {
    simulation = context.simulation();
    actions = context.actions();
    messages = context.language().messages(PowerPanel.class);
    error = new Sentence(messages, "power-error", Styles.DANGER);
    on = simulation.selectedProperty().flatMap(FxDroneModel::onProperty);
    initializeSelf();
    initializeParts();
    layoutParts();
    setupEventHandlers();
    setupBindings();
  }

  private void initializeSelf() {
    getStyleClass().add("power-panel");
  }

  private void initializeParts() {
    power.setId("power");
    power.getStyleClass().add("power");
    power.setGraphic(new FontIcon(Feather.POWER));
    power.setMaxWidth(Double.MAX_VALUE);
    power.setMinHeight(USE_PREF_SIZE);
    Hint.on(power, messages.text("power.hint"));
  }

  private void layoutParts() {
    getChildren().addAll(power, error);
  }

  private void setupEventHandlers() {
    power.setOnAction(pressed -> use(power.isSelected()));
  }

  private void setupBindings() {
    power
        .textProperty()
        .bind(on.flatMap(isOn -> messages.text(isOn ? "power.stop" : "power.start")));
    on.addListener((property, before, now) -> power.setSelected(now));
    power.setSelected(on.getValue());
    simulation.selectedProperty().addListener((property, before, now) -> forgetError());
  }

  private void use(boolean wanted) {
    Optional<PortTakenException> obstacle =
        actions.switchPower(simulation.selected().number(), wanted);
    error.say(obstacle.map(PowerPanel::explain));
    power.setSelected(wanted && obstacle.isEmpty());
  }

  /** Whatever was wrong with the ports, they are others now. */
  void forgetError() {
    error.say(Optional.empty());
  }

  private static Complaint explain(PortTakenException obstacle) {
    InetSocketAddress address = obstacle.address();
    String host = address.getAddress().getHostAddress();
    String port = Integer.toString(address.getPort());
    return switch (obstacle.obstacle()) {
      case TAKEN -> new Complaint("power.taken", port, host);
      case TAKEN_BY_OPERATOR -> new Complaint("power.taken-by-operator", port, host);
      case FORBIDDEN -> new Complaint("power.forbidden", port, host);
      case OFF_LIMITS -> new Complaint("power.off-limits", host);
      case NO_SUCH_ADDRESS ->
          address.getAddress().isLoopbackAddress()
              ? new Complaint("power.no-loopback", host)
              : new Complaint("power.no-address", host);
    };
  }
}
