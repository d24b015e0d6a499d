package tellosimulator.view.controls;

import atlantafx.base.controls.Spacer;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import javafx.beans.value.ObservableValue;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.layout.ColumnConstraints;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.VBox;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.model.FlightPhase;
import tellosimulator.sim.Control;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;

/**
 * What the selected drone is doing: its phase in words, battery, instruments and numbers. For the
 * JavaFX thread.
 */
final class FlightPanel extends VBox {

  /** Size of the round instruments [px]; two and the height bar fill the panel's width. */
  private static final double DIAL = 94;

  private static final int NUMBERS_IN_A_ROW = 4;

  /** Width of a column of numbers [%]; the last one has a longer name and gets the rest. */
  private static final double NARROW = 22;

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final Messages messages;
  private final PhaseLabel phase = new PhaseLabel();
  private final BatteryGauge battery;
  private final Button charge = new Button();
  private final AttitudeIndicator attitude;
  private final Compass compass;
  private final HeightBar height;
  private final List<Readout> numbers;

  FlightPanel(ViewContext context) {
    simulation = context.simulation();
    actions = context.actions();
    messages = context.language().messages(FlightPanel.class);
    battery = new BatteryGauge(messages);
    attitude = new AttitudeIndicator(messages, DIAL);
    compass = new Compass(messages, DIAL);
    height = new HeightBar(messages, DIAL);
    numbers =
        List.of(
            number("x", FxDroneModel::xCmProperty),
            number("y", FxDroneModel::yCmProperty),
            number("z", FxDroneModel::zCmProperty),
            number("speed", FxDroneModel::speedCmProperty),
            number("yaw", FxDroneModel::yawDegProperty),
            number("pitch", FxDroneModel::pitchDegProperty),
            number("roll", FxDroneModel::rollDegProperty),
            number("flight-time", FlightPanel::motorTime));
    initializeSelf();
    initializeParts();
    layoutParts();
    setupEventHandlers();
    setupBindings();
  }

  private void initializeSelf() {
    getStyleClass().addAll("panel-section", "flight-panel");
  }

  private void initializeParts() {
    phase.setId("phase");
    phase.setMinWidth(USE_PREF_SIZE);
    charge.setId("battery-charge");
    charge.setGraphic(new FontIcon(Feather.BATTERY_CHARGING));
    charge.getStyleClass().addAll("icon-button");
    Tooltips.install(charge, messages.text("battery.charge"));
    charge.accessibleTextProperty().bind(messages.text("battery.charge"));
  }

  private void layoutParts() {
    HBox head = new HBox(4, phase, new Spacer(), battery, charge);
    head.setAlignment(Pos.CENTER_LEFT);
    HBox dials = new HBox(attitude, compass, height);
    dials.getStyleClass().add("dials");
    GridPane table = new GridPane();
    table.getStyleClass().add("numbers");
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

  private void setupEventHandlers() {
    charge.setOnAction(
        pressed -> actions.carryOut(new Control.SetBattery(simulation.selected().number(), 100)));
  }

  private void setupBindings() {
    battery.percentProperty().bind(selected(FxDroneModel::batteryPercentProperty));
    attitude.pitchDegProperty().bind(selected(FxDroneModel::pitchDegProperty));
    attitude.rollDegProperty().bind(selected(FxDroneModel::rollDegProperty));
    compass.yawDegProperty().bind(selected(FxDroneModel::yawDegProperty));
    height.heightCmProperty().bind(selected(FxDroneModel::zCmProperty));
    height.ceilingCmProperty().bind(simulation.roomProperty().map(room -> room.height() * 100));
    ObservableValue<FlightPhase> present = selected(FxDroneModel::phaseProperty);
    present.addListener((property, before, now) -> show(now));
    show(present.getValue());
  }

  private void show(FlightPhase now) {
    phase.textProperty().bind(messages.text(keyOf(now)));
    phase.show(now);
  }

  /** The key of a phase's words. */
  static String keyOf(FlightPhase phase) {
    return "phase." + phase.name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  private Readout number(String id, Function<FxDroneModel, ObservableValue<Number>> part) {
    Readout readout = new Readout(id, messages.text("number." + id));
    readout.valueProperty().bind(selected(part));
    return readout;
  }

  private static ObservableValue<Number> motorTime(FxDroneModel drone) {
    return drone.snapshotProperty().map(snapshot -> snapshot.state().energy().motorTime());
  }

  private <T> ObservableValue<T> selected(
      Function<FxDroneModel, ? extends ObservableValue<? extends T>> part) {
    return simulation.selectedProperty().flatMap(part);
  }
}
