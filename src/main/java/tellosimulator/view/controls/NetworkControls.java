package tellosimulator.view.controls;

import atlantafx.base.theme.Styles;
import java.util.Arrays;
import java.util.List;
import java.util.function.UnaryOperator;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.Label;
import javafx.scene.layout.VBox;
import tellosimulator.command.OperatorEndpoint;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.view.controls.SegmentedButton.Option;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;

/**
 * The panel at the right, with the power switch and the controls for network, product, time, wind
 * and faults. Confined to the JavaFX thread.
 */
public final class NetworkControls extends ControlPanel {

  /** Width of the panel [px]. Decided: fits the longest address and a button. */
  private static final double WIDTH = 256;

  /** Time between two updates of packets and addresses [ns]. Decided: four updates a second. */
  private static final long PERIOD_NANOS = 250_000_000;

  private final ConnectionPanel link;
  private final PortsPanel ports;
  private final TimePanel time;

  public NetworkControls(ViewContext context) {
    super("network-controls", WIDTH);
    PowerPanel power = new PowerPanel(context);
    link = new ConnectionPanel(context);
    ports = new PortsPanel(context, power::forgetError);
    ProductPanel product = new ProductPanel(context);
    time = new TimePanel(context);
    WindPanel wind = new WindPanel(context);
    FaultPanel faults = new FaultPanel(context);
    layoutPanel(power, link, ports, product, time, wind, faults);
    foldInOrder(faults, wind, product, time, ports);
    context
        .simulation()
        .selected(FxDroneModel::onProperty)
        .addListener((property, before, now) -> refresh());
    visibleProperty().subscribe(this::refresh);
    DrawingClock.run(context, PERIOD_NANOS, this::refreshIfVisible);
  }

  /**
   * Updates the panel only if it is visible, because JavaFX redraws the whole window for each
   * change.
   */
  private void refreshIfVisible() {
    if (isVisible()) {
      refresh();
    }
  }

  private void refresh() {
    link.refresh();
    ports.refresh();
    time.refresh();
  }

  /**
   * Sets the product and the reference model of the selected drone. Enabled while the drone is off.
   * Confined to the JavaFX thread.
   */
  private static final class ProductPanel extends Card {

    private final FxSimulation simulation;
    private final SimulatorActions actions;
    private final SegmentedButton<Profile> profile;
    private final SegmentedButton<Behavior> behavior;

    ProductPanel(ViewContext context) {
      super("product", context.language().messages(ProductPanel.class).text("heading.product"));
      simulation = context.simulation();
      actions = context.actions();
      Messages messages = context.language().messages(ProductPanel.class);
      profile =
          new SegmentedButton<>(
              "profile",
              Arrays.stream(Profile.values())
                  .map(value -> Option.of(messages, "profile", value, value.option()))
                  .toList(),
              chosen -> configure(old -> new Product(chosen, old.behavior())));
      behavior =
          new SegmentedButton<>(
              "behaviour",
              Arrays.stream(Behavior.values())
                  .map(value -> Option.of(messages, "behaviour", value, value.option()))
                  .toList(),
              chosen -> configure(old -> new Product(old.profile(), chosen)));
      layoutCard(profile, behavior);
      setupBindings();
    }

    private void setupBindings() {
      ObservableValue<DroneSnapshot> drone = simulation.selected(FxDroneModel::snapshotProperty);
      ObservableValue<Product> product = drone.map(DroneSnapshot::product);
      product.addListener((property, before, now) -> show(now));
      show(product.getValue());
      ObservableValue<Boolean> on = simulation.selected(FxDroneModel::onProperty);
      for (SegmentedButton<?> choice : List.of(profile, behavior)) {
        choice.disableProperty().bind(on);
      }
    }

    private void show(Product product) {
      profile.show(product.profile());
      behavior.show(product.behavior());
    }

    private void configure(UnaryOperator<Product> change) {
      FxDroneModel drone = simulation.selected();
      DroneSnapshot snapshot = drone.snapshotProperty().get();
      OperatorEndpoint link = snapshot.link();
      actions.carryOut(
          new Control.Configure(
              drone.number(),
              change.apply(snapshot.product()),
              new StreamPorts(link.statePort(), link.videoPort())));
    }
  }

  /**
   * The selected drone's power switch, with a message if one of the drone's ports is not available.
   * Confined to the JavaFX thread.
   */
  private static final class PowerPanel extends VBox {

    private final PowerSwitch power;

    PowerPanel(ViewContext context) {
      power = new PowerSwitch(context, "power");
      power.setMaxWidth(Double.MAX_VALUE);
      Label problem = Nodes.sentence("power-error", "sentence", Styles.DANGER);
      problem.setMaxWidth(Double.MAX_VALUE);
      problem.textProperty().bind(power.problemProperty());
      Nodes.styled(this, "power-panel");
      getChildren().addAll(power, problem);
    }

    /** Clears the error message, which is obsolete once the ports have changed. */
    void forgetError() {
      power.forgetProblem();
    }
  }
}
