package tellosimulator.view.controls;

import javafx.scene.shape.LineTo;
import javafx.scene.shape.MoveTo;
import javafx.scene.shape.Path;

/**
 * Positions on a round dial, and its tick marks as one node.
 *
 * @param middle of the dial, from its left and top [px]
 * @param radius of the dial [px]
 */
record DialScale(double middle, double radius) {

  /**
   * Marks from the rim inwards.
   *
   * @param inner where they end, as a part of the radius
   * @param anglesDeg where they are, clockwise from the top
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

  /** Where a point is, from the left [px]; {@code distance} is a part of the radius. */
  double x(double angleDeg, double distance) {
    return middle + Math.sin(Math.toRadians(angleDeg)) * distance * radius;
  }

  /** Where a point is, from the top [px]; {@code distance} is a part of the radius. */
  double y(double angleDeg, double distance) {
    return middle - Math.cos(Math.toRadians(angleDeg)) * distance * radius;
  }
}
