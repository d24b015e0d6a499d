package tellosimulator.view.controls;

import javafx.scene.control.ScrollPane;
import javafx.scene.layout.VBox;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;

/**
 * The panel at the right: power switch, network, product, time, wind and faults. For the JavaFX
 * thread.
 */
public final class NetworkControls extends ScrollPane {

  /** Width of the panel [px]. Decided: the longest address and a button. */
  private static final double WIDTH = 256;

  /** Time between two looks at packets and addresses [ns]. Decided: four a second. */
  private static final long PERIOD_NANOS = 250_000_000;

  private final PowerPanel power;
  private final LinkPanel link;
  private final PortsPanel ports;
  private final ProductPanel product;
  private final TimePanel time;
  private final WindPanel wind;
  private final FaultPanel faults;
  private final VBox parts = new VBox();
  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private long lookedNanos = Long.MIN_VALUE;

  public NetworkControls(ViewContext context) {
    simulation = context.simulation();
    actions = context.actions();
    power = new PowerPanel(context);
    link = new LinkPanel(context);
    ports = new PortsPanel(context, power::forgetError);
    product = new ProductPanel(context);
    time = new TimePanel(context);
    wind = new WindPanel(context);
    faults = new FaultPanel(context);
    initializeSelf();
    layoutParts();
    setupBindings();
    context.pulse().onBeat(this::beat);
  }

  private void initializeSelf() {
    setId("network-controls");
    getStyleClass().add("control-panel");
    getStylesheets().add(NetworkControls.class.getResource("controls.css").toExternalForm());
    setFitToWidth(true);
    setHbarPolicy(ScrollBarPolicy.NEVER);
    setMinWidth(WIDTH);
    setPrefWidth(WIDTH);
    setMaxWidth(WIDTH);
  }

  private void layoutParts() {
    parts.getStyleClass().add("parts");
    parts.getChildren().addAll(power, link, ports, product, time, wind, faults);
    setContent(parts);
  }

  private void setupBindings() {
    simulation
        .selectedProperty()
        .flatMap(FxDroneModel::onProperty)
        .addListener((property, before, now) -> refresh());
  }

  private void beat(long nanos) {
    long period = simulation.period(PERIOD_NANOS);
    boolean due = nanos / period != lookedNanos / period; // with others in the same frame
    if (due && !actions.pending()) {
      lookedNanos = nanos;
      refresh();
    }
  }

  private void refresh() {
    link.refresh();
    ports.refresh();
    time.refresh();
  }
}
