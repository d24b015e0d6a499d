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
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;

/**
 * The panel at the left, with the state of the selected drone and the controls for the room.
 * Confined to the JavaFX thread.
 */
public final class SimulatorControls extends ControlPanel {

  /** Width of the panel [px]. Decided: fits two instruments and a height bar. */
  private static final double WIDTH = 280;

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final BooleanProperty droneCamera = new SimpleBooleanProperty(this, "droneCamera");
  private final ProgramPanel program;
  private final ChartPanel charts;
  private final ToggleButton cameraSwitch = Nodes.named(new ToggleButton(), "camera-switch");

  public SimulatorControls(ViewContext context) {
    super("simulator-controls", WIDTH);
    simulation = context.simulation();
    actions = context.actions();
    Messages messages = context.language().messages(SimulatorControls.class);
    program = new ProgramPanel(context);
    charts = new ChartPanel(context);
    RoomPanel room = new RoomPanel(context);
    MorePanel more = new MorePanel(context);
    setFitToHeight(true);
    VBox.setVgrow(charts, Priority.ALWAYS);
    layoutPanel(
        new DroneComboBox(context.scene()),
        new FlightPanel(context),
        buttons(messages),
        program,
        charts,
        room,
        more);
    foldInOrder(more, program, charts, room);
    charts.usefulProperty().subscribe(this::makeRoom);
    // the room card may fold or unfold
    context.scenario().challengeProperty().subscribe(asked -> foldSoon());
  }

  private HBox buttons(Messages messages) {
    Button reset =
        Nodes.button(
            "reset", Feather.ROTATE_CCW, messages.text("reset"), messages.text("reset.hint"));
    reset.setOnAction(
        pressed -> actions.carryOut(new Control.Reset(simulation.selected().number())));
    cameraSwitch.setGraphic(new FontIcon(Feather.VIDEO));
    cameraSwitch
        .textProperty()
        .bind(
            droneCamera.flatMap(
                drone -> messages.text(drone ? "camera.simulator" : "camera.drone")));
    cameraSwitch.selectedProperty().bindBidirectional(droneCamera);
    Tooltips.install(cameraSwitch, messages.text("camera.hint"));
    return new HBox(8, Nodes.growing(reset), Nodes.growing(cameraSwitch));
  }

  /** Folds the first program once there is a flight that the charts can show. */
  private void makeRoom(boolean flown) {
    program.setUseful(!flown);
    foldSoon();
  }

  /** Whether the scene is seen through the drone's camera; toggled by a button of the panel. */
  public BooleanProperty droneCameraProperty() {
    return droneCamera;
  }

  /**
   * The panel with a first program, for users who have not written any program yet. Confined to the
   * JavaFX thread.
   */
  private static final class ProgramPanel extends Card {

    /** Time between two updates of the address [ns]. Decided: four updates a second. */
    private static final long PERIOD_NANOS = 250_000_000;

    private final FxSimulation simulation;
    private final SimulatorActions actions;
    private final FirstProgram program;

    ProgramPanel(ViewContext context) {
      super("program", context.language().messages(ProgramPanel.class).text("program.heading"));
      simulation = context.simulation();
      actions = context.actions();
      program = new FirstProgram("panel", context.language());
      layoutCard(program);
      layoutHead(program.copyButton());
      refresh();
      simulation.selectedProperty().subscribe(this::refresh);
      DrawingClock.run(context, PERIOD_NANOS, this::refresh);
    }

    private void refresh() {
      program.fly(actions.addresses(simulation.selected().number()));
    }
  }
}
