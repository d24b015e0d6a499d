package tellosimulator.view;

import javafx.application.Application;
import javafx.geometry.Rectangle2D;
import javafx.scene.Scene;
import javafx.scene.layout.StackPane;
import javafx.stage.Screen;
import javafx.stage.Stage;
import tellosimulator.view.controls.NetworkControls;
import tellosimulator.view.controls.SimulatorControls;
import tellosimulator.view.layout.SimulatorPane;
import tellosimulator.view.layout.WindowBar;
import tellosimulator.view.layout.WindowState;
import tellosimulator.view.pilot.PilotControls;
import tellosimulator.view.world.Simulator3DScene;
import tellosimulator.view.world.ViewCamera;

/** The window with all its parts. For the JavaFX thread. */
public final class SimulatorWindow implements AutoCloseable {

  /** Size at first [px]. Decided: what fits on a small notebook. */
  private static final double WIDTH = 1280;

  private static final double HEIGHT = 800;

  private final WindowState state = new WindowState();
  private final Simulator3DScene scene3d;
  private final PilotControls pilot;
  private final SimulatorControls simulatorControls;

  /** Builds the window, and does not show it yet. */
  public SimulatorWindow(Stage stage, ViewContext context) {
    scene3d = new Simulator3DScene(context);
    pilot = new PilotControls(context);
    simulatorControls = new SimulatorControls(context);
    SimulatorPane pane =
        new SimulatorPane(
            new SimulatorPane.Parts(
                new WindowBar(context, state, scene3d),
                new SimulatorPane.Middle(scene3d, pilot),
                simulatorControls,
                new NetworkControls(context),
                new StackPane()),
            state);
    Scene scene = new Scene(new StackPane(pane));
    pilot.install(scene);
    setupBindings();
    stage.setScene(scene);
    stage.setTitle("Tello Simulator");
    Rectangle2D screen = Screen.getPrimary().getVisualBounds();
    stage.setWidth(Math.min(WIDTH, screen.getWidth()));
    stage.setHeight(Math.min(HEIGHT, screen.getHeight()));
  }

  private void setupBindings() {
    state
        .themeProperty()
        .subscribe(theme -> Application.setUserAgentStylesheet(theme.stylesheet()));
    simulatorControls
        .droneCameraProperty()
        .subscribe(
            drone ->
                scene3d.viewCameraProperty().set(drone ? ViewCamera.DRONE : ViewCamera.SIMULATOR));
    scene3d
        .viewCameraProperty()
        .subscribe(
            camera -> simulatorControls.droneCameraProperty().set(camera == ViewCamera.DRONE));
  }

  /** What the window itself can be switched to. */
  public WindowState state() {
    return state;
  }

  @Override
  public void close() {
    pilot.close();
  }
}
