package tellosimulator.view.controls;

import java.net.InetSocketAddress;
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
import tellosimulator.view.FxDroneModel;
import tellosimulator.view.SimulatorActions;
import tellosimulator.view.ViewContext;
import tellosimulator.view.drone.DroneColors;
import tellosimulator.view.text.Messages;

/** A drone in a list: number and colour, state, battery, where to reach it. */
final class DroneRow extends ListCell<FxDroneModel> {

  private static final PseudoClass IN_THE_AIR = PseudoClass.getPseudoClass("in-the-air");
  private static final PseudoClass IN_TROUBLE = PseudoClass.getPseudoClass("in-trouble");
  private static final PseudoClass OFF = PseudoClass.getPseudoClass("off");
  private static final PseudoClass LOW = PseudoClass.getPseudoClass("low");

  private static final double STATE_WIDTH = 96;
  private static final double BATTERY_WIDTH = 42;

  /** The rows of one list; there are only as many as are seen. */
  static final class Rows {

    private final SimulatorActions actions;
    private final Messages messages;
    private final List<DroneRow> all = new ArrayList<>();

    Rows(ViewContext context, Messages messages) {
      this.actions = context.actions();
      this.messages = messages;
      context.language().localeProperty().addListener((property, before, now) -> refresh());
    }

    /** Another row. */
    DroneRow row() {
      DroneRow row = new DroneRow(this);
      all.add(row);
      return row;
    }

    /** Takes over how the drones are now. */
    void refresh() {
      all.forEach(DroneRow::refresh);
    }
  }

  private final Rows rows;
  private final Circle colour = new Circle(9);
  private final Label number = new Label();
  private final Label state = new Label();
  private final Label battery = new Label();
  private final Label address = new Label();
  private final HBox parts = new HBox();

  private DroneRow(Rows rows) {
    this.rows = rows;
    number.getStyleClass().add("badge");
    state.getStyleClass().add("phase");
    battery.getStyleClass().add("battery");
    address.getStyleClass().add("address");
    state.setMinWidth(STATE_WIDTH);
    battery.setMinWidth(BATTERY_WIDTH);
    address.setMaxWidth(Double.MAX_VALUE);
    HBox.setHgrow(address, Priority.ALWAYS);
    parts.getStyleClass().add("drone-row");
    parts.getChildren().addAll(new StackPane(colour, number), state, battery, address);
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
      colour.setFill(own);
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
    state.pseudoClassStateChanged(OFF, phase == FlightPhase.OFF);
    state.pseudoClassStateChanged(IN_THE_AIR, phase.motorsOn());
    state.pseudoClassStateChanged(
        IN_TROUBLE, phase == FlightPhase.FALLING || phase == FlightPhase.CRASHED);
    double percent = Math.rint(drone.batteryPercentProperty().get());
    battery.setText(NumberText.whole(percent) + " %");
    battery.pseudoClassStateChanged(LOW, percent <= 2 * Battery.TOO_LOW_FOR_TAKEOFF);
    address.setText(address(drone.number()));
  }

  private String address(int drone) {
    List<InetSocketAddress> addresses = AddressOrder.mostUsefulFirst(rows.actions.addresses(drone));
    InetSocketAddress first = addresses.get(0);
    String host = first.getAddress().getHostAddress();
    return first.getPort() == 0 ? host : host + ":" + first.getPort();
  }
}
