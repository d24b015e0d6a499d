package tellosimulator.view.plan;

import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;

/** A distance measured with the plan's ruler. Immutable. */
record MeasuredDistance(Vec3 from, Vec3 to) {

  /**
   * Formats the length and the direction, for example {@code 123 cm, 45°}. The direction is
   * counter-clockwise from the room's x axis.
   */
  String text() {
    Vec3 way = to.minus(from);
    long degrees = Math.round(Math.toDegrees(Math.atan2(way.y(), way.x())));
    return Math.round(Frames.centimeters(way.horizontal().norm())) + " cm, " + degrees + "°";
  }
}
