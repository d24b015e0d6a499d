package tellosimulator.view.controls;

import java.util.ArrayList;
import java.util.List;
import javafx.css.PseudoClass;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.StackPane;
import javafx.scene.paint.Color;
import javafx.scene.shape.Circle;
import tellosimulator.model.Battery;
import tellosimulator.model.FlightPhase;
import tellosimulator.view.drone.DroneColors;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;

/** A drone in a list: number and colour, state, battery, where to reach it. */
final class DroneCell extends ListCell<FxDroneModel> {

  private static final PseudoClass LOW = PseudoClass.getPseudoClass("low");

  private static final double STATE_WIDTH = 96;
  private static final double BATTERY_WIDTH = 42;

  /** The rows of one list; there are only as many as are seen. */
  static final class Rows {

    private final SimulatorActions actions;
    private final Messages messages;
    private final List<DroneCell> all = new ArrayList<>();

    Rows(ViewContext context, Messages messages) {
      this.actions = context.actions();
      this.messages = messages;
      context.language().localeProperty().addListener((property, before, now) -> refresh());
    }

    /** Another row. */
    DroneCell row() {
      DroneCell row = new DroneCell(this);
      all.add(row);
      return row;
    }

    /** Takes over how the drones are now. */
    void refresh() {
      all.forEach(DroneCell::refresh);
    }
  }

  private final Rows rows;
  private final Circle color = new Circle(9);
  private final Label number = new Label();
  private final PhaseLabel state = new PhaseLabel();
  private final Label battery = new Label();
  private final Label address = new Label();
  private final HBox parts = new HBox();

  private DroneCell(Rows rows) {
    this.rows = rows;
    number.getStyleClass().add("badge");
    battery.getStyleClass().add("battery");
    address.getStyleClass().add("address");
    state.setMinWidth(STATE_WIDTH);
    battery.setMinWidth(BATTERY_WIDTH);
    address.setMaxWidth(Double.MAX_VALUE);
    HBox.setHgrow(address, Priority.ALWAYS);
    parts.getStyleClass().add("drone-row");
    parts.getChildren().addAll(new StackPane(color, number), state, battery, address);
    setPrefWidth(0); // never wider than the list
  }

  @Override
  protected void updateItem(FxDroneModel drone, boolean empty) {
    super.updateItem(drone, empty);
    if (empty || drone == null) {
      setGraphic(null);
    } else {
      number.setText(Integer.toString(drone.number()));
      Color own = DroneColors.of(drone);
      color.setFill(own);
      number.setTextFill(DroneColors.inkOn(own));
      setGraphic(parts);
      refresh();
    }
  }

  private void refresh() {
    FxDroneModel drone = getItem();
    if (drone == null) {
      return;
    }
    FlightPhase phase = drone.phaseProperty().get();
    state.setText(rows.messages.now(FlightPanel.keyOf(phase)));
    state.show(phase);
    double percent = Math.rint(drone.batteryPercentProperty().get());
    battery.setText(NumberText.whole(percent) + " %");
    battery.pseudoClassStateChanged(LOW, percent <= 2 * Battery.TOO_LOW_FOR_TAKEOFF);
    address.setText(address(drone.number()));
  }

  private String address(int drone) {
    return AddressList.text(AddressList.mostUsefulFirst(rows.actions.addresses(drone)).get(0));
  }
}
