package tellosimulator.view.controls;

import javafx.beans.property.Property;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.beans.value.ObservableValue;
import javafx.css.PseudoClass;
import javafx.scene.control.ToggleButton;
import javafx.scene.shape.Circle;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;

/**
 * A button that shows and hides the network panel. It displays the address at which the selected
 * drone accepts commands, and a lamp that shows the state of the connection. Confined to the JavaFX
 * thread.
 */
public final class LinkButton extends ToggleButton {

  /** Time between two updates of the address [ns]. Decided: four updates a second. */
  private static final long PERIOD_NANOS = 250_000_000;

  /**
   * Minimum width [px]. It prevents the labels of other buttons from appearing and disappearing
   * when a program connects. Measured: the width of the button with an address of this machine and
   * the longest text for a state.
   */
  private static final double LEAST_WIDTH = 206;

  /** Radius of the lamp [px]. */
  private static final double RADIUS = 4.5;

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final ReadOnlyStringWrapper address = new ReadOnlyStringWrapper("");

  /**
   * @param panelShown whether the network panel is shown
   */
  public LinkButton(ViewContext context, Property<Boolean> panelShown) {
    simulation = context.simulation();
    actions = context.actions();
    Messages messages = context.language().messages(LinkButton.class);
    Nodes.named(this, "show-network", "link-button");
    setGraphic(Nodes.styled(new Circle(RADIUS), "lamp"));
    selectedProperty().bindBidirectional(panelShown);
    Tooltips.install(this, messages.text("link.hint"));
    ObservableValue<ConnectionState> state =
        simulation.selected(FxDroneModel::snapshotProperty).map(ConnectionState::of);
    textProperty().bind(state.flatMap(now -> messages.text("link." + now.key(), address)));
    state.subscribe(this::light);
    simulation.selectedProperty().subscribe(this::refresh);
    DrawingClock.run(context, PERIOD_NANOS, this::refresh);
  }

  @Override
  protected double computePrefWidth(double height) {
    return Math.max(LEAST_WIDTH, super.computePrefWidth(height));
  }

  private void light(ConnectionState now) {
    for (ConnectionState state : ConnectionState.values()) {
      pseudoClassStateChanged(PseudoClass.getPseudoClass(state.key()), state == now);
    }
  }

  private void refresh() {
    int drone = simulation.selected().number();
    address.set(AddressList.mostUseful(actions.addresses(drone)));
  }
}
