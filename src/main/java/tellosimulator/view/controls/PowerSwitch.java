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
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Message;
import tellosimulator.view.text.Messages;

/**
 * The power switch of the selected drone. It also provides the reason why the drone could not be
 * switched on. Confined to the JavaFX thread.
 */
public final class PowerSwitch extends ToggleButton {

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final Messages messages;
  private final ReadOnlyStringWrapper problem = new ReadOnlyStringWrapper(this, "problem", "");

  /**
   * @param id the id of the control in the window
   */
  public PowerSwitch(ViewContext context, String id) {
    simulation = context.simulation();
    actions = context.actions();
    messages = context.language().messages(PowerSwitch.class);
    Nodes.named(this, id, "power");
    setGraphic(new FontIcon(Feather.POWER));
    setMinHeight(USE_PREF_SIZE);
    Tooltips.install(this, messages.text("power.hint"));
    setOnAction(pressed -> use(isSelected()));
    ObservableValue<Boolean> on = simulation.selected(FxDroneModel::onProperty);
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

  /** The reason why the drone could not be switched on, as a sentence; empty if it could. */
  public ReadOnlyStringProperty problemProperty() {
    return problem.getReadOnlyProperty();
  }

  /** Clears the message, which is obsolete once the ports have changed. */
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
