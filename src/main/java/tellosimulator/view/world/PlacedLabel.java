package tellosimulator.view.world;

import java.util.Optional;
import javafx.geometry.Point2D;
import javafx.scene.control.Label;
import javafx.scene.layout.Pane;
import tellosimulator.math.Vec3;

/** A label below a place of the room, in a pane over the 3D view. Confined to the JavaFX thread. */
final class PlacedLabel extends Label {

  /**
   * Distance from the place to the text [px]. Decided: clear of a drone's body from most distances.
   */
  private static final double BELOW = 18;

  PlacedLabel(String styleClass) {
    getStyleClass().add(styleClass);
    setVisible(false);
  }

  /**
   * Shows a text below a place, or hides it if the place is out of view.
   *
   * @param place the place in the room frame [m]
   */
  void show(String text, Vec3 place, Viewpoint viewpoint, Pane picture) {
    Optional<Point2D> seen = viewpoint.project(place, picture.getWidth(), picture.getHeight());
    setVisible(seen.isPresent());
    if (seen.isPresent()) {
      setText(text);
      autosize();
      relocate(Math.rint(seen.get().getX() - getWidth() / 2), Math.rint(seen.get().getY() + BELOW));
    }
  }
}
