package tellosimulator.view.controls;

import atlantafx.base.controls.Spacer;
import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import javafx.beans.value.ObservableValue;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.layout.ColumnConstraints;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.VBox;
import org.kordamp.ikonli.feather.Feather;
import tellosimulator.math.Frames;
import tellosimulator.model.FlightPhase;
import tellosimulator.sim.Control;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;

/**
 * Shows the phase, battery and motion of the selected drone, as instruments and numbers. Confined
 * to the JavaFX thread.
 */
final class FlightPanel extends VBox {

  /**
   * Size of the round instruments [px]. Two of them and the height bar fill the width of the panel.
   */
  private static final double DIAL = 94;

  private static final int NUMBERS_IN_A_ROW = 4;

  /**
   * Width of a column of numbers [%]. The last column takes the rest, because its name is longer.
   */
  private static final double NARROW = 22;

  private final FxSimulation simulation;
  private final Messages messages;
  private final PhaseLabel phase = Nodes.named(new PhaseLabel(), "phase");
  private final BatteryGauge battery;
  private final Button charge;
  private final AttitudeIndicator attitude;
  private final Compass compass;
  private final HeightBar height;
  private final List<Readout> numbers;

  FlightPanel(ViewContext context) {
    simulation = context.simulation();
    messages = context.language().messages(FlightPanel.class);
    battery = new BatteryGauge(messages);
    attitude = new AttitudeIndicator(messages, DIAL);
    compass = new Compass(messages, DIAL);
    height = new HeightBar(messages, DIAL);
    numbers =
        List.of(
            number("x", FxDroneModel::xCm),
            number("y", FxDroneModel::yCm),
            number("z", FxDroneModel::zCm),
            number("speed", FxDroneModel::speedCm),
            number("yaw", FxDroneModel::yawDeg),
            number("pitch", FxDroneModel::pitchDeg),
            number("roll", FxDroneModel::rollDeg),
            number(
                "flight-time",
                drone -> drone.snapshotProperty().get().state().energy().motorTime()));
    charge =
        Nodes.iconButton(
            "battery-charge", Feather.BATTERY_CHARGING, messages.text("battery.charge"));
    charge.setOnAction(
        pressed ->
            context
                .actions()
                .carryOut(new Control.SetBattery(simulation.selected().number(), 100)));
    Nodes.styled(this, "panel-section", "flight-panel");
    layoutParts();
    setupBindings();
  }

  private void layoutParts() {
    HBox head = new HBox(4, Nodes.unshrinkable(phase), new Spacer(), battery, charge);
    head.setAlignment(Pos.CENTER_LEFT);
    HBox dials = Nodes.styled(new HBox(attitude, compass, height), "dials");
    GridPane table = Nodes.styled(new GridPane(), "numbers");
    for (int i = 0; i < NUMBERS_IN_A_ROW; i++) {
      ColumnConstraints column = new ColumnConstraints();
      column.setPercentWidth(
          i + 1 < NUMBERS_IN_A_ROW ? NARROW : 100 - (NUMBERS_IN_A_ROW - 1) * NARROW);
      table.getColumnConstraints().add(column);
    }
    for (int i = 0; i < numbers.size(); i++) {
      table.add(numbers.get(i), i % NUMBERS_IN_A_ROW, i / NUMBERS_IN_A_ROW);
    }
    getChildren().addAll(head, dials, table);
  }

  private void setupBindings() {
    simulation
        .selected(FxDroneModel::snapshotProperty)
        .subscribe(snapshot -> show(simulation.selected()));
    simulation.roomProperty().subscribe(room -> show(simulation.selected()));
    simulation.selected(FxDroneModel::phaseProperty).subscribe(this::showPhase);
  }

  private void show(FxDroneModel drone) {
    battery.show(drone.snapshotProperty().get().state().energy().battery().percent());
    attitude.show(drone.pitchDeg(), drone.rollDeg());
    compass.show(drone.yawDeg());
    height.show(drone.zCm(), Frames.centimeters(simulation.roomProperty().get().height()));
    numbers.forEach(number -> number.show(drone));
  }

  private void showPhase(FlightPhase now) {
    phase.textProperty().bind(messages.text(keyOf(now)));
    phase.show(now);
  }

  /** Returns the key of a phase's text. */
  static String keyOf(FlightPhase phase) {
    return "phase." + phase.name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  private Readout number(String id, ToDoubleFunction<FxDroneModel> value) {
    return new Readout(id, messages.text("number." + id), value);
  }

  /** A number without decimals, with its name and unit above it. Confined to the JavaFX thread. */
  private static final class Readout extends VBox {

    private final Label number = Nodes.styled(new Label("0"), "number");
    private final ToDoubleFunction<FxDroneModel> value;
    private long shown;

    /**
     * @param id the id of the label with the number
     */
    Readout(String id, ObservableValue<String> name, ToDoubleFunction<FxDroneModel> value) {
      this.value = value;
      Nodes.styled(this, "readout");
      Label caption = Nodes.styled(new Label(), "caption");
      caption.textProperty().bind(name);
      caption.setLabelFor(number);
      number.setId(id);
      getChildren().addAll(caption, Nodes.unshrinkable(number));
    }

    void show(FxDroneModel drone) {
      long whole = Math.round(value.applyAsDouble(drone));
      if (whole != shown) {
        shown = whole;
        number.setText(Long.toString(whole));
      }
    }
  }
}
