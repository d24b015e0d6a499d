package tellosimulator.view.world;

import java.util.Optional;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.geometry.Point2D;
import javafx.scene.layout.Pane;
import javafx.scene.shape.Circle;
import tellosimulator.view.model.FxSimulation;

/**
 * A circle that shows for a moment which of several drones was chosen: it closes in on the drone.
 * For the JavaFX thread.
 */
final class SelectionMark extends Pane {

  /** How long it is there [s]. Decided: long enough to find it in a large picture. */
  static final double SECONDS = 1.5;

  /** How long it closes in [s]. Decided: the glance that it takes to follow it. */
  private static final double CLOSING = 0.4;

  /** Radius at last, and how much larger it is at first [px]. Decided: around a drone nearby. */
  private static final double RADIUS = 36;

  private static final double WIDER = 60;

  private final FxSimulation simulation;
  private final BooleanProperty still = new SimpleBooleanProperty(this, "still");
  private final Circle circle = new Circle(RADIUS);
  private boolean chosen;
  private double age = SECONDS;
  private long lastNanos;

  SelectionMark(FxSimulation simulation) {
    this.simulation = simulation;
    circle.getStyleClass().add("selection-mark");
    getChildren().setAll(circle);
    setMouseTransparent(true);
    setManaged(false);
    setVisible(false);
    simulation.selectedProperty().addListener((property, before, now) -> chosen = true);
  }

  /** Whether it stays as large as it is. */
  BooleanProperty stillProperty() {
    return still;
  }

  /**
   * Follows the drone.
   *
   * @param nanos the time of the picture [ns]
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
