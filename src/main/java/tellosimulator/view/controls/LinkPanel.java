package tellosimulator.view.controls;

import atlantafx.base.controls.Spacer;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.beans.value.ObservableValue;
import javafx.css.PseudoClass;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import javafx.scene.shape.Circle;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.model.FlightPhase;
import tellosimulator.network.Traffic;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Message;
import tellosimulator.view.text.Messages;

/**
 * Who commands the selected drone, what it sends, and how many packets came and went. For the
 * JavaFX thread.
 */
final class LinkPanel extends VBox {

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final Messages messages;
  private final Label operator = new Label();
  private final Button release = new Button();
  private final Lamp state;
  private final Lamp video;
  private final ReadOnlyStringWrapper received = new ReadOnlyStringWrapper("0");
  private final ReadOnlyStringWrapper sent = new ReadOnlyStringWrapper("0");

  LinkPanel(ViewContext context) {
    simulation = context.simulation();
    actions = context.actions();
    messages = context.language().messages(LinkPanel.class);
    ObservableValue<DroneSnapshot> drone =
        simulation.selectedProperty().flatMap(FxDroneModel::snapshotProperty);
    state = new Lamp("state-lamp", messages, "lamp.state", drone.map(LinkPanel::linked));
    video =
        new Lamp(
            "video-lamp",
            messages,
            "lamp.video",
            simulation.selectedProperty().flatMap(FxDroneModel::filmingProperty));
    initializeSelf();
    initializeParts();
    layoutParts();
    setupBindings(drone.map(LinkPanel::describe));
    drone.map(LinkPanel::linked).subscribe(this::offerRelease);
  }

  private void initializeSelf() {
    getStyleClass().addAll("panel-section", "link-panel");
  }

  private void initializeParts() {
    operator.setId("operator");
    operator.setGraphic(new FontIcon(Feather.LINK));
    operator.getStyleClass().add("operator");
    operator.setMaxWidth(Double.MAX_VALUE);
    operator.setWrapText(true);
    operator.setMinHeight(USE_PREF_SIZE);
    HBox.setHgrow(operator, Priority.ALWAYS);
    release.setId("release");
    release.setGraphic(new FontIcon(Feather.USER_X));
    release.getStyleClass().add("icon-button");
    release.setOnAction(
        pressed -> actions.carryOut(new Control.Release(simulation.selected().number())));
    release.accessibleTextProperty().bind(messages.text("release.hint"));
    Tooltips.install(release, messages.text("release.hint"));
  }

  private void layoutParts() {
    HBox lamps = new HBox(state, new Spacer(), video);
    HBox packets =
        new HBox(
            packets("packets-in", Feather.ARROW_DOWN, received),
            new Spacer(),
            packets("packets-out", Feather.ARROW_UP, sent));
    HBox who = new HBox(operator, release);
    who.getStyleClass().add("row");
    getChildren().addAll(who, lamps, packets);
  }

  private void setupBindings(ObservableValue<Message> who) {
    operator.textProperty().bind(who.flatMap(now -> now.text(messages)));
  }

  /** Not bound: it would ask for a layout of the whole panel at each new snapshot. */
  private void offerRelease(boolean linked) {
    release.setVisible(linked);
    release.setManaged(linked);
  }

  /** Counts anew. */
  void refresh() {
    Traffic traffic = actions.traffic(simulation.selected().number());
    received.set(NumberText.count(traffic.received()));
    sent.set(NumberText.count(traffic.sent()));
  }

  private static boolean linked(DroneSnapshot drone) {
    return drone.state().phase() != FlightPhase.OFF && drone.link().sdkMode();
  }

  /** Equal as long as the same is said, so that nothing is written anew. */
  private static Message describe(DroneSnapshot drone) {
    return switch (LinkState.of(drone)) {
      case OFF -> Message.of("operator.off");
      case WAITING -> Message.of("operator.waits");
      case CONNECTED ->
          Message.of("operator.known", drone.link().operator().orElseThrow().toString());
    };
  }

  private Label packets(String id, Feather icon, ObservableValue<String> count) {
    Label label = new Label();
    label.setId(id);
    label.setGraphic(new FontIcon(icon));
    label.getStyleClass().add("packets");
    label.textProperty().bind(count.flatMap(number -> messages.text(id, number)));
    return label;
  }

  /** A lamp with words that say whether something runs. For the JavaFX thread. */
  private static final class Lamp extends Label {

    private static final PseudoClass LIT = PseudoClass.getPseudoClass("lit");

    /**
     * @param key of its words, with {@code .on} or {@code .off} behind
     */
    Lamp(String id, Messages messages, String key, ObservableValue<Boolean> runs) {
      setId(id);
      getStyleClass().add("lamp");
      Circle light = new Circle(4);
      light.getStyleClass().add("light");
      setGraphic(light);
      textProperty().bind(runs.flatMap(lit -> messages.text(key + (lit ? ".on" : ".off"))));
      runs.addListener((property, before, now) -> pseudoClassStateChanged(LIT, now));
      pseudoClassStateChanged(LIT, runs.getValue());
    }
  }
}
