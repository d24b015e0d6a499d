package tellosimulator.view.controls;

import javafx.scene.shape.LineTo;
import javafx.scene.shape.MoveTo;
import javafx.scene.shape.Path;

/**
 * Computes positions on a round dial, and creates its tick marks as one node.
 *
 * @param middle the distance of the centre from the left edge, and also from the top edge [px]
 * @param radius the radius of the dial [px]
 */
record DialScale(double middle, double radius) {

  /**
   * Returns tick marks that extend from the rim inwards.
   *
   * @param inner the inner end of the marks, as a fraction of the radius
   * @param anglesDeg the positions, clockwise from the top
   */
  Path marks(double inner, double... anglesDeg) {
    Path path = new Path();
    for (double angle : anglesDeg) {
      path.getElements().add(new MoveTo(x(angle, 1), y(angle, 1)));
      path.getElements().add(new LineTo(x(angle, inner), y(angle, inner)));
    }
    path.getStyleClass().add("marks");
    return path;
  }

  /**
   * Returns the distance of a point from the left edge [px]; {@code distance} is a fraction of the
   * radius.
   */
  double x(double angleDeg, double distance) {
    return middle + Math.sin(Math.toRadians(angleDeg)) * distance * radius;
  }

  /**
   * Returns the distance of a point from the top edge [px]; {@code distance} is a fraction of the
   * radius.
   */
  double y(double angleDeg, double distance) {
    return middle - Math.cos(Math.toRadians(angleDeg)) * distance * radius;
  }
}
