package tellosimulator.view.controls;

import atlantafx.base.controls.Spacer;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.beans.value.ObservableValue;
import javafx.css.PseudoClass;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.VBox;
import javafx.scene.shape.Circle;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.model.FlightPhase;
import tellosimulator.network.Traffic;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Message;
import tellosimulator.view.text.Messages;

/**
 * Shows the operator of the selected drone, whether the drone sends its state and its video, and
 * the number of packets in each direction. Confined to the JavaFX thread.
 */
final class ConnectionPanel extends VBox {

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final Messages messages;
  private final Label operator = Nodes.named(new Label(), "operator", "operator");
  private final Button release;
  private final ReadOnlyStringWrapper received = new ReadOnlyStringWrapper("0");
  private final ReadOnlyStringWrapper sent = new ReadOnlyStringWrapper("0");

  ConnectionPanel(ViewContext context) {
    simulation = context.simulation();
    actions = context.actions();
    messages = context.language().messages(ConnectionPanel.class);
    ObservableValue<DroneSnapshot> drone = simulation.selected(FxDroneModel::snapshotProperty);
    Lamp state = new Lamp("state-lamp", messages, "lamp.state", drone.map(ConnectionPanel::linked));
    Lamp video =
        new Lamp(
            "video-lamp",
            messages,
            "lamp.video",
            simulation.selected(FxDroneModel::filmingProperty));
    operator.setGraphic(new FontIcon(Feather.LINK));
    operator
        .textProperty()
        .bind(drone.map(ConnectionPanel::describe).flatMap(now -> now.text(messages)));
    Nodes.growing(Nodes.wrapping(operator));
    release = Nodes.iconButton("release", Feather.USER_X, messages.text("release.hint"));
    release.setOnAction(
        pressed -> actions.carryOut(new Control.Release(simulation.selected().number())));
    Nodes.styled(this, "panel-section", "link-panel");
    layoutParts(new HBox(state, new Spacer(), video));
    drone.map(ConnectionPanel::linked).subscribe(this::offerRelease);
  }

  private void layoutParts(HBox lamps) {
    HBox packets =
        new HBox(
            packets("packets-in", Feather.ARROW_DOWN, received),
            new Spacer(),
            packets("packets-out", Feather.ARROW_UP, sent));
    HBox who = Nodes.styled(new HBox(operator, release), "row");
    getChildren().addAll(who, lamps, packets);
  }

  /**
   * Shows or hides the button that releases the operator. This is not a binding, because a binding
   * would request a layout of the whole panel for every new snapshot.
   */
  private void offerRelease(boolean linked) {
    Nodes.setShown(release, linked);
  }

  /** Updates the number of packets. */
  void refresh() {
    Traffic traffic = actions.traffic(simulation.selected().number());
    received.set(NumberText.count(traffic.received()));
    sent.set(NumberText.count(traffic.sent()));
  }

  private static boolean linked(DroneSnapshot drone) {
    return drone.state().phase() != FlightPhase.OFF && drone.link().sdkMode();
  }

  /**
   * Describes the connection. Equal connections give equal messages, so that the label is updated
   * only if the connection changes.
   */
  private static Message describe(DroneSnapshot drone) {
    return switch (ConnectionState.of(drone)) {
      case OFF -> Message.of("operator.off");
      case WAITING -> Message.of("operator.waits");
      case CONNECTED ->
          Message.of("operator.known", drone.link().operator().orElseThrow().toString());
    };
  }

  private Label packets(String id, Feather icon, ObservableValue<String> count) {
    Label label = Nodes.named(new Label("", new FontIcon(icon)), id, "packets");
    label.textProperty().bind(count.flatMap(number -> messages.text(id, number)));
    return label;
  }

  /** A lamp and a text that show whether a stream is running. Confined to the JavaFX thread. */
  private static final class Lamp extends Label {

    private static final PseudoClass LIT = PseudoClass.getPseudoClass("lit");

    /**
     * @param key the key of its texts, without the suffix {@code .on} or {@code .off}
     */
    Lamp(String id, Messages messages, String key, ObservableValue<Boolean> runs) {
      Nodes.named(this, id, "lamp");
      Circle light = Nodes.styled(new Circle(4), "light");
      setGraphic(light);
      textProperty().bind(runs.flatMap(lit -> messages.text(key + (lit ? ".on" : ".off"))));
      runs.addListener((property, before, now) -> pseudoClassStateChanged(LIT, now));
      pseudoClassStateChanged(LIT, runs.getValue());
    }
  }
}
