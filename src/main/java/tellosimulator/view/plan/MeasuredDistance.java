package tellosimulator.view.plan;

import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;

/** A distance that somebody measures on the plan. Immutable. */
record MeasuredDistance(Vec3 from, Vec3 to) {

  /** Length and direction, counter-clockwise from the room's x: {@code 123 cm, 45°}. */
  String text() {
    Vec3 way = to.minus(from);
    long degrees = Math.round(Math.toDegrees(Math.atan2(way.y(), way.x())));
    return Math.round(Frames.centimeters(way.horizontal().norm())) + " cm, " + degrees + "°";
  }
}
