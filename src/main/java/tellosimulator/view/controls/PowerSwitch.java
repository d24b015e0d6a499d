package tellosimulator.view.controls;

import java.net.InetSocketAddress;
import java.util.Optional;
import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.ToggleButton;
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
 * The selected drone's power switch, and why it could not be switched on. For the JavaFX thread.
 */
public final class PowerSwitch extends ToggleButton {

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final Messages messages;
  private final ReadOnlyStringWrapper problem = new ReadOnlyStringWrapper(this, "problem", "");

  /**
   * @param id by which the control is found in the window
   */
  public PowerSwitch(ViewContext context, String id) {
    simulation = context.simulation();
    actions = context.actions();
    messages = context.language().messages(PowerSwitch.class);
    setId(id);
    getStyleClass().add("power");
    setGraphic(new FontIcon(Feather.POWER));
    setMinHeight(USE_PREF_SIZE);
    Tooltips.install(this, messages.text("power.hint"));
    setOnAction(pressed -> use(isSelected()));
    setupBindings();
  }

  private void setupBindings() {
    ObservableValue<Boolean> on = simulation.selectedProperty().flatMap(FxDroneModel::onProperty);
    textProperty().bind(on.flatMap(isOn -> messages.text(isOn ? "power.stop" : "power.start")));
    on.addListener((property, before, now) -> setSelected(now));
    setSelected(on.getValue());
    simulation.selectedProperty().addListener((property, before, now) -> forgetProblem());
  }

  private void use(boolean wanted) {
    int drone = simulation.selected().number();
    actions.switchPower(
        drone,
        wanted,
        refusal -> {
          if (simulation.selected().number() == drone) {
            say(refusal.map(PowerSwitch::explain));
            setSelected(wanted && refusal.isEmpty());
          }
        });
  }

  /** A sentence that says why the drone could not be switched on; empty if it could. */
  public ReadOnlyStringProperty problemProperty() {
    return problem.getReadOnlyProperty();
  }

  /** Whatever was wrong with the ports, they are others now. */
  public void forgetProblem() {
    say(Optional.empty());
  }

  private void say(Optional<Message> refusal) {
    problem.unbind();
    refusal.ifPresentOrElse(what -> problem.bind(what.text(messages)), () -> problem.set(""));
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
