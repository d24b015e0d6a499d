package tellosimulator.view.controls;

import java.util.Arrays;
import java.util.List;
import java.util.function.UnaryOperator;
import javafx.beans.value.ObservableValue;
import tellosimulator.command.Link;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;

/**
 * Which product the selected drone is, and after which account; can be changed while it is off. For
 * the JavaFX thread.
 */
final class ProductPanel extends Card {

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final Messages messages;
  private final SegmentedButton<Profile> profile;
  private final SegmentedButton<Behavior> behavior;

  ProductPanel(ViewContext context) {
    super("product", context.language().messages(ProductPanel.class).text("heading.product"));
    simulation = context.simulation();
    actions = context.actions();
    messages = context.language().messages(ProductPanel.class);
    profile =
        new SegmentedButton<>(
            "profile",
            Arrays.stream(Profile.values()).map(this::option).toList(),
            chosen -> configure(old -> new Product(chosen, old.behavior())));
    behavior =
        new SegmentedButton<>(
            "behaviour",
            Arrays.stream(Behavior.values()).map(this::option).toList(),
            chosen -> configure(old -> new Product(old.profile(), chosen)));
    layoutCard(profile, behavior);
    setupBindings();
  }

  private void setupBindings() {
    ObservableValue<DroneSnapshot> drone =
        simulation.selectedProperty().flatMap(FxDroneModel::snapshotProperty);
    ObservableValue<Product> product = drone.map(DroneSnapshot::product);
    product.addListener((property, before, now) -> show(now));
    show(product.getValue());
    ObservableValue<Boolean> on = simulation.selectedProperty().flatMap(FxDroneModel::onProperty);
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
    Link link = snapshot.link();
    actions.carryOut(
        new Control.Configure(
            drone.number(),
            change.apply(snapshot.product()),
            new StreamPorts(link.statePort(), link.videoPort())));
  }

  private SegmentedButton.Option<Profile> option(Profile value) {
    return option(value, "profile.", value.option());
  }

  private SegmentedButton.Option<Behavior> option(Behavior value) {
    return option(value, "behaviour.", value.option());
  }

  private <T> SegmentedButton.Option<T> option(T value, String key, String word) {
    return new SegmentedButton.Option<>(
        value, word, messages.text(key + word), messages.text(key + word + ".hint"));
  }
}
