package tellosimulator.view.controls;

import javafx.beans.property.Property;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.beans.value.ObservableValue;
import javafx.css.PseudoClass;
import javafx.scene.control.ToggleButton;
import javafx.scene.shape.Circle;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;

/**
 * Says where the selected drone takes commands and whether an operator is there, with a lamp; shows
 * and hides the panel that says more. For the JavaFX thread.
 */
public final class LinkButton extends ToggleButton {

  /** Time between two looks at the address [ns]. Decided: four a second. */
  private static final long PERIOD_NANOS = 250_000_000;

  /**
   * Least width [px]: words of buttons beside it do not come and go with a program. Measured: what
   * an address of this machine and the longest state need.
   */
  private static final double LEAST_WIDTH = 206;

  /** Radius of the lamp [px]. */
  private static final double RADIUS = 4.5;

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final ReadOnlyStringWrapper address = new ReadOnlyStringWrapper("");
  private final DrawingClock clock;

  /**
   * @param panelShown whether the panel that says more is there
   */
  public LinkButton(ViewContext context, Property<Boolean> panelShown) {
    simulation = context.simulation();
    actions = context.actions();
    clock = new DrawingClock(simulation, PERIOD_NANOS);
    Messages messages = context.language().messages(LinkButton.class);
    setId("show-network");
    getStyleClass().add("link-button");
    Circle lamp = new Circle(RADIUS);
    lamp.getStyleClass().add("lamp");
    setGraphic(lamp);
    selectedProperty().bindBidirectional(panelShown);
    Tooltips.install(this, messages.text("link.hint"));
    ObservableValue<LinkState> state =
        simulation.selectedProperty().flatMap(FxDroneModel::snapshotProperty).map(LinkState::of);
    textProperty().bind(state.flatMap(now -> messages.text("link." + now.key(), address)));
    state.subscribe(this::light);
    simulation.selectedProperty().subscribe(this::refresh);
    context.pulse().onBeat(this::beat);
  }

  @Override
  protected double computePrefWidth(double height) {
    return Math.max(LEAST_WIDTH, super.computePrefWidth(height));
  }

  private void light(LinkState now) {
    for (LinkState state : LinkState.values()) {
      pseudoClassStateChanged(PseudoClass.getPseudoClass(state.key()), state == now);
    }
  }

  private void beat(long nanos) {
    if (clock.due(nanos) && !actions.pending()) {
      clock.take(nanos);
      refresh();
    }
  }

  private void refresh() {
    int drone = simulation.selected().number();
    address.set(AddressList.text(AddressList.mostUsefulFirst(actions.addresses(drone)).get(0)));
  }
}
