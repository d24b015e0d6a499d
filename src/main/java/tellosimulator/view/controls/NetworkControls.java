package tellosimulator.view.controls;

import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;

/**
 * The panel at the right: power switch, network, product, time, wind and faults. For the JavaFX
 * thread.
 */
public final class NetworkControls extends ControlPanel {

  /** Width of the panel [px]. Decided: the longest address and a button. */
  private static final double WIDTH = 256;

  /** Time between two looks at packets and addresses [ns]. Decided: four a second. */
  private static final long PERIOD_NANOS = 250_000_000;

  private final LinkPanel link;
  private final PortsPanel ports;
  private final TimePanel time;
  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final DrawingClock clock;

  public NetworkControls(ViewContext context) {
    super("network-controls", WIDTH);
    simulation = context.simulation();
    actions = context.actions();
    clock = new DrawingClock(simulation, PERIOD_NANOS);
    PowerPanel power = new PowerPanel(context);
    link = new LinkPanel(context);
    ports = new PortsPanel(context, power::forgetError);
    ProductPanel product = new ProductPanel(context);
    time = new TimePanel(context);
    WindPanel wind = new WindPanel(context);
    FaultPanel faults = new FaultPanel(context);
    layoutPanel(power, link, ports, product, time, wind, faults);
    foldInOrder(faults, wind, product, time, ports);
    setupBindings();
    context.pulse().onBeat(this::beat);
  }

  private void setupBindings() {
    simulation
        .selectedProperty()
        .flatMap(FxDroneModel::onProperty)
        .addListener((property, before, now) -> refresh());
    visibleProperty().subscribe(this::refresh);
  }

  /** Changes nothing that cannot be seen: JavaFX draws the whole window anew for it. */
  private void beat(long nanos) {
    if (isVisible() && clock.due(nanos) && !actions.pending()) {
      clock.take(nanos);
      refresh();
    }
  }

  private void refresh() {
    link.refresh();
    ports.refresh();
    time.refresh();
  }
}
