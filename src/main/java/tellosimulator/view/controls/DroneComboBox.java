package tellosimulator.view.controls;

import javafx.scene.control.ComboBox;
import javafx.scene.control.ListCell;
import javafx.scene.shape.Circle;
import tellosimulator.view.drone.DroneColors;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SceneContext;
import tellosimulator.view.text.Messages;

/**
 * Selects the drone that panels and cameras show. Visible only if there are several drones.
 * Confined to the JavaFX thread.
 */
public final class DroneComboBox extends ComboBox<FxDroneModel> {

  private final FxSimulation simulation;
  private final Messages messages;

  /** Creates a combo box with the drones of a window. */
  public DroneComboBox(SceneContext context) {
    this.simulation = context.simulation();
    this.messages = context.language().messages(DroneComboBox.class);
    initializeSelf();
    valueProperty().bindBidirectional(simulation.selectedProperty());
  }

  private void initializeSelf() {
    setId("drone-choice");
    setMaxWidth(Double.MAX_VALUE);
    setItems(simulation.drones());
    setCellFactory(list -> new DroneCell());
    setButtonCell(new DroneCell());
    accessibleTextProperty().bind(messages.text("drone.choice"));
    boolean several = simulation.drones().size() > 1;
    Nodes.setShown(this, several);
  }

  /** A cell with the number, colour, state and battery of a drone. */
  private final class DroneCell extends ListCell<FxDroneModel> {

    private final Circle dot = new Circle(5);

    @Override
    protected void updateItem(FxDroneModel drone, boolean empty) {
      super.updateItem(drone, empty);
      textProperty().unbind();
      if (empty || drone == null) {
        setText("");
        setGraphic(null);
      } else {
        dot.setFill(DroneColors.of(drone));
        setGraphic(dot);
        textProperty()
            .bind(
                messages.text(
                    "drone.entry",
                    drone.number(),
                    drone.phaseProperty().flatMap(phase -> messages.text(FlightPanel.keyOf(phase))),
                    drone
                        .batteryPercentProperty()
                        .map(percent -> NumberText.whole(percent.doubleValue()))));
      }
    }
  }
}
