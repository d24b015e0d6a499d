package tellosimulator.view.projector;

import java.util.Locale;
import javafx.css.PseudoClass;
import javafx.geometry.Insets;
import javafx.scene.control.Label;
import javafx.scene.layout.Background;
import javafx.scene.layout.BackgroundFill;
import javafx.scene.layout.CornerRadii;
import javafx.scene.layout.HBox;
import javafx.scene.paint.Color;
import tellosimulator.model.FlightPhase;
import tellosimulator.view.drone.DroneColors;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.text.Messages;

/** A drone in large type: its number in its color, what it does, its battery. */
final class DroneChip extends HBox {

  private static final PseudoClass IN_TROUBLE = PseudoClass.getPseudoClass("in-trouble");
  private static final PseudoClass LOW = PseudoClass.getPseudoClass("low");

  /** A battery below this is low [%]. Decided: the drone still has time to land. */
  private static final double LOW_PERCENT = 20;

  /** From so many drones on they are many. Decided: numbers alone fit into two rows. */
  private static final int MANY = 8;

  private final FxDroneModel drone;
  private final Messages messages;
  private final int drones;
  private final Label state = new Label();
  private final Label battery = new Label();

  /**
   * @param drones how many chips there are: one says what its drone does, others only if that is in
   *     trouble; of many, those say their battery that is low
   */
  DroneChip(FxDroneModel drone, Messages messages, int drones) {
    this.drone = drone;
    this.messages = messages;
    this.drones = drones;
    state.managedProperty().bind(state.visibleProperty());
    battery.managedProperty().bind(battery.visibleProperty());
    Color color = DroneColors.of(drone);
    Label number = new Label(String.valueOf(drone.number()));
    number.getStyleClass().add("badge");
    number.setTextFill(DroneColors.inkOn(color));
    number.setBackground(
        new Background(new BackgroundFill(color, new CornerRadii(50, true), Insets.EMPTY)));
    setId("projector-drone-" + drone.number());
    getStyleClass().add("chip");
    setMinWidth(USE_PREF_SIZE);
    getChildren().addAll(number, state, battery);
  }

  /** Takes over how the drone is now. */
  void refresh() {
    FlightPhase phase = drone.phaseProperty().get();
    state.setText(messages.now("phase." + phase.name().toLowerCase(Locale.ROOT)));
    boolean inTrouble = phase == FlightPhase.FALLING || phase == FlightPhase.CRASHED;
    pseudoClassStateChanged(IN_TROUBLE, inTrouble);
    state.setVisible(drones == 1 || inTrouble);
    double percent = drone.batteryPercentProperty().get();
    battery.setText(messages.now("battery", percent));
    battery.pseudoClassStateChanged(LOW, percent < LOW_PERCENT);
    battery.setVisible(drones < MANY || percent < LOW_PERCENT);
  }
}
