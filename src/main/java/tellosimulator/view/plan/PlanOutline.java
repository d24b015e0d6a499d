package tellosimulator.view.plan;

import java.util.List;
import java.util.stream.Stream;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Shape;

/**
 * The area that an item covers on the floor: a circle, or a rectangle that turns with the item.
 * Immutable.
 *
 * @param depth the extent along the item's x axis [m]
 * @param width the extent along the item's y axis [m]
 * @param round whether the outline is a circle
 */
record PlanOutline(double depth, double width, boolean round) {

  /**
   * Thickness of a hanging mission pad in the plan [m]. Decided: large enough to be seen and
   * grabbed.
   */
  static final double HANGING = 0.04;

  static PlanOutline circle(double radius) {
    return new PlanOutline(2 * radius, 2 * radius, true);
  }

  /** Returns the outline of a drone. */
  static PlanOutline ofDrone() {
    return circle(DroneSpec.COLLIDER.radius());
  }

  /** Returns the outline of a mission pad; a hanging one is seen edge-on. */
  static PlanOutline of(MissionPad pad) {
    return new PlanOutline(
        pad.surface().wall() ? HANGING : MissionPad.EDGE, MissionPad.EDGE, false);
  }

  /** Returns the outline of an obstacle. */
  static PlanOutline of(Shape shape) {
    return new PlanOutline(shape.size().x(), shape.size().y(), shape.round());
  }

  /**
   * Returns whether the outline covers a place on the floor.
   *
   * @param margin the distance by which the outline is enlarged [m]
   */
  boolean covers(Vec3 place, Placement placement, double margin) {
    Vec3 own = placement.toOwn(place);
    if (round) {
      return Math.hypot(own.x(), own.y()) <= width / 2 + margin;
    }
    return Math.abs(own.x()) <= depth / 2 + margin && Math.abs(own.y()) <= width / 2 + margin;
  }

  /** Returns the maximum distance of the outline from its middle [m]. */
  double reach() {
    return round ? width / 2 : Math.hypot(depth, width) / 2;
  }

  /**
   * Returns points of the outline in the room frame [m]: the corners of a rectangle, or the four
   * points of a circle in the directions of the room's axes.
   */
  List<Vec3> corners(Placement placement) {
    double x = depth / 2;
    double y = width / 2;
    if (round) {
      return Stream.of(new Vec3(x, 0, 0), new Vec3(0, y, 0), new Vec3(-x, 0, 0), new Vec3(0, -y, 0))
          .map(placement.place()::plus)
          .toList();
    }
    return Stream.of(new Vec3(x, y, 0), new Vec3(-x, y, 0), new Vec3(-x, -y, 0), new Vec3(x, -y, 0))
        .map(placement::toRoom)
        .toList();
  }
}
