package tellosimulator.view.world;

import javafx.geometry.Pos;
import javafx.scene.control.Label;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import javafx.scene.shape.Circle;
import javafx.scene.shape.Polygon;
import javafx.scene.transform.Rotate;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SceneContext;
import tellosimulator.view.text.Messages;

/**
 * An arrow in the direction of the wind, relative to the camera: upwards means away from the
 * camera. The arrow is hidden in calm air. Confined to the JavaFX thread.
 */
final class WindArrow extends VBox {

  /** Radius of the arrow's circle [px]. */
  private static final double RADIUS = 18;

  /** Speed below which the air counts as calm [m/s]. */
  private static final double CALM = 0.005;

  private final FxSimulation simulation;
  private final SimulatorCamera camera;
  private final Rotate turn = new Rotate();
  private final Label speed = new Label();

  WindArrow(SceneContext context, SimulatorCamera camera) {
    this.simulation = context.simulation();
    this.camera = camera;
    Messages messages = context.language().messages(WindArrow.class);
    Circle rim = new Circle(RADIUS);
    rim.getStyleClass().add("rim");
    Polygon arrow = new Polygon(0, -14, 8, 3, 2.5, 1, 2.5, 14, -2.5, 14, -2.5, 1, -8, 3);
    arrow.getStyleClass().add("arrow");
    arrow.getTransforms().add(turn);
    speed
        .textProperty()
        .bind(simulation.arenaProperty().flatMap(arena -> messages.text("wind", cm(mean()))));
    setId("wind-arrow");
    getStyleClass().add("wind-arrow");
    setAlignment(Pos.CENTER);
    setMaxSize(USE_PREF_SIZE, USE_PREF_SIZE);
    setMouseTransparent(true);
    getChildren().addAll(new StackPane(rim, arrow), speed);
    setVisible(false);
  }

  /**
   * Updates the direction, which also depends on the camera.
   *
   * @param wanted whether the arrow may be shown
   */
  void advance(boolean wanted) {
    Vec3 mean = mean();
    boolean blows = wanted && mean.norm() > CALM;
    if (blows != isVisible()) {
      setVisible(blows);
    }
    if (blows) {
      double heading = Math.atan2(mean.y(), mean.x());
      turn.setAngle(Math.toDegrees(camera.pose().attitude().heading() - heading));
    }
  }

  private Vec3 mean() {
    return simulation.arenaProperty().get().wind().mean().horizontal();
  }

  private static long cm(Vec3 velocity) {
    return Math.round(Frames.centimeters(velocity.norm()));
  }
}
