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
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Message;
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
  private final MessageLabel error;
  private final ObservableValue<Boolean> on;

  PowerPanel(ViewContext context) {
    simulation = context.simulation();
    actions = context.actions();
    messages = context.language().messages(PowerPanel.class);
    error = new MessageLabel(messages, "power-error", Styles.DANGER);
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
    Tooltips.install(power, messages.text("power.hint"));
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
    int drone = simulation.selected().number();
    actions.switchPower(
        drone,
        wanted,
        refusal -> {
          if (simulation.selected().number() == drone) {
            error.say(refusal.map(PowerPanel::explain));
            power.setSelected(wanted && refusal.isEmpty());
          }
        });
  }

  /** Whatever was wrong with the ports, they are others now. */
  void forgetError() {
    error.say(Optional.empty());
  }

  private static Message explain(PortTakenException obstacle) {
    InetSocketAddress address = obstacle.address();
    String host = address.getAddress().getHostAddress();
    String port = Integer.toString(address.getPort());
    return switch (obstacle.obstacle()) {
      case TAKEN -> Message.of("power.taken", port, host);
      case TAKEN_BY_OPERATOR -> Message.of("power.taken-by-operator", port, host);
      case FORBIDDEN -> Message.of("power.forbidden", port, host);
      case OFF_LIMITS -> Message.of("power.off-limits", host);
      case NO_SUCH_ADDRESS ->
          address.getAddress().isLoopbackAddress()
              ? Message.of("power.no-loopback", host)
              : Message.of("power.no-address", host);
    };
  }
}
