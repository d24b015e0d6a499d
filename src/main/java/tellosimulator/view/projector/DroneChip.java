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

/** A drone in large type: its number in its colour, what it does, its battery. */
final class DroneChip extends HBox {

  private static final PseudoClass IN_TROUBLE = PseudoClass.getPseudoClass("in-trouble");
  private static final PseudoClass LOW = PseudoClass.getPseudoClass("low");

  /** A battery below this is low [%]. Decided: the drone still has time to land. */
  private static final double LOW_PERCENT = 20;

  private final FxDroneModel drone;
  private final Messages messages;
  private final Label state = new Label();
  private final Label battery = new Label();

  /**
   * @param worded whether it says what the drone does
   */
  DroneChip(FxDroneModel drone, Messages messages, boolean worded) {
    this.drone = drone;
    this.messages = messages;
    Color color = DroneColors.of(drone);
    Label number = new Label(String.valueOf(drone.number()));
    number.getStyleClass().add("badge");
    number.setTextFill(DroneColors.inkOn(color));
    number.setBackground(
        new Background(new BackgroundFill(color, new CornerRadii(50, true), Insets.EMPTY)));
    setId("projector-drone-" + drone.number());
    getStyleClass().add("chip");
    setMinWidth(USE_PREF_SIZE);
    getChildren().add(number);
    if (worded) {
      getChildren().add(state);
    }
    getChildren().add(battery);
  }

  /** Takes over how the drone is now. */
  void refresh() {
    FlightPhase phase = drone.phaseProperty().get();
    state.setText(messages.now("phase." + phase.name().toLowerCase(Locale.ROOT)));
    pseudoClassStateChanged(
        IN_TROUBLE, phase == FlightPhase.FALLING || phase == FlightPhase.CRASHED);
    double percent = drone.batteryPercentProperty().get();
    battery.setText(messages.now("battery", percent));
    battery.pseudoClassStateChanged(LOW, percent < LOW_PERCENT);
  }
}
