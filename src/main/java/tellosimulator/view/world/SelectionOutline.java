package tellosimulator.view.world;

import java.util.Optional;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.geometry.Point2D;
import javafx.scene.layout.Pane;
import javafx.scene.shape.Circle;
import tellosimulator.view.model.FxSimulation;

/**
 * A circle that briefly highlights a newly selected drone if there are several. The circle shrinks
 * towards the drone. Confined to the JavaFX thread.
 */
final class SelectionOutline extends Pane {

  /** Duration of the highlight [s]. Decided: long enough to find the drone in a large view. */
  static final double SECONDS = 1.5;

  /** Time in which the circle shrinks [s]. Decided: slow enough for the eyes to follow. */
  private static final double CLOSING = 0.4;

  /**
   * Final radius [px]. The initial radius is larger by {@link #WIDER}. Decided: encloses a nearby
   * drone.
   */
  private static final double RADIUS = 36;

  private static final double WIDER = 60;

  private final FxSimulation simulation;
  private final BooleanProperty still = new SimpleBooleanProperty(this, "still");
  private final Circle circle = new Circle(RADIUS);
  private boolean chosen;
  private double age = SECONDS;
  private long lastNanos;

  SelectionOutline(FxSimulation simulation) {
    this.simulation = simulation;
    circle.getStyleClass().add("selection-mark");
    getChildren().setAll(circle);
    setMouseTransparent(true);
    setManaged(false);
    setVisible(false);
    simulation.selectedProperty().addListener((property, before, now) -> chosen = true);
  }

  /** Whether the circle keeps its size instead of shrinking. */
  BooleanProperty stillProperty() {
    return still;
  }

  /**
   * Moves the circle with the drone.
   *
   * @param nanos the time of the frame [ns]
   * @param wanted whether the drone can be seen
   */
  void advance(long nanos, boolean wanted, Viewpoint viewpoint) {
    age = chosen ? 0 : age + (nanos - lastNanos) / 1e9;
    chosen = false;
    lastNanos = nanos;
    Optional<Point2D> place =
        viewpoint.project(
            simulation.selected().poseProperty().get().position(), getWidth(), getHeight());
    boolean shown = wanted && age < SECONDS && place.isPresent();
    if (shown != isVisible()) {
      setVisible(shown);
    }
    if (shown) {
      double open = still.get() ? 0 : Math.max(0, 1 - age / CLOSING);
      circle.setRadius(RADIUS + WIDER * open * open);
      circle.relocate(
          place.get().getX() - circle.getRadius(), place.get().getY() - circle.getRadius());
    }
  }
}
