package tellosimulator.view.controls;

import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.scene.control.Button;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.sim.Control;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;

/**
 * The panel at the left: what the drone does, and the room in which it does it. For the JavaFX
 * thread.
 */
public final class SimulatorControls extends ControlPanel {

  /** Width of the panel [px]. Decided: room for two instruments and a height bar. */
  private static final double WIDTH = 280;

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final Messages messages;
  private final BooleanProperty droneCamera = new SimpleBooleanProperty(this, "droneCamera");
  private final DroneComboBox choice;
  private final FlightPanel flight;
  private final ProgramPanel program;
  private final ChartPanel charts;
  private final RoomPanel room;
  private final MorePanel more;
  private final Button reset = new Button();
  private final ToggleButton cameraSwitch = new ToggleButton();

  public SimulatorControls(ViewContext context) {
    super("simulator-controls", WIDTH);
    simulation = context.simulation();
    actions = context.actions();
    messages = context.language().messages(SimulatorControls.class);
    choice = new DroneComboBox(context.scene());
    flight = new FlightPanel(context);
    program = new ProgramPanel(context);
    charts = new ChartPanel(context);
    room = new RoomPanel(context);
    more = new MorePanel(context);
    initializeParts();
    layoutParts();
    setupEventHandlers();
    setupBindings();
    context.scenario().challengeProperty().subscribe(asked -> foldSoon()); // as its room is
  }

  private void initializeParts() {
    reset.setId("reset");
    reset.setGraphic(new FontIcon(Feather.ROTATE_CCW));
    cameraSwitch.setId("camera-switch");
    cameraSwitch.setGraphic(new FontIcon(Feather.VIDEO));
    Tooltips.install(reset, messages.text("reset.hint"));
    Tooltips.install(cameraSwitch, messages.text("camera.hint"));
  }

  private void layoutParts() {
    reset.setMaxWidth(Double.MAX_VALUE);
    cameraSwitch.setMaxWidth(Double.MAX_VALUE);
    HBox.setHgrow(reset, Priority.ALWAYS);
    HBox.setHgrow(cameraSwitch, Priority.ALWAYS);
    HBox buttons = new HBox(8, reset, cameraSwitch);
    setFitToHeight(true);
    VBox.setVgrow(charts, Priority.ALWAYS);
    layoutPanel(choice, flight, buttons, program, charts, room, more);
    foldInOrder(more, program, charts, room);
  }

  private void setupEventHandlers() {
    reset.setOnAction(
        pressed -> actions.carryOut(new Control.Reset(simulation.selected().number())));
  }

  private void setupBindings() {
    reset.textProperty().bind(messages.text("reset"));
    cameraSwitch
        .textProperty()
        .bind(
            droneCamera.flatMap(
                drone -> messages.text(drone ? "camera.simulator" : "camera.drone")));
    cameraSwitch.selectedProperty().bindBidirectional(droneCamera);
    charts.usefulProperty().subscribe(this::makeRoom);
  }

  /** The first program has flown when there is something for the charts to show. */
  private void makeRoom(boolean flown) {
    program.setUseful(!flown);
    foldSoon();
  }

  /** Whether the scene shall be seen through the drone's camera; the button switches it. */
  public BooleanProperty droneCameraProperty() {
    return droneCamera;
  }
}
