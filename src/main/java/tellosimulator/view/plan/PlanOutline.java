package tellosimulator.view.plan;

import java.util.List;
import java.util.stream.Stream;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.world.Footprint;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Shape;

/**
 * What something covers of the floor, seen from above: a circle or a rectangle, turned with its
 * placement. Immutable.
 *
 * @param depth along its x axis [m]
 * @param width along its y axis [m]
 * @param round whether it is a circle
 */
record PlanOutline(double depth, double width, boolean round) {

  /** Thickness with which a hanging mission pad is drawn [m]. Decided: to be seen and caught. */
  static final double HANGING = 0.04;

  static PlanOutline circle(double radius) {
    return new PlanOutline(2 * radius, 2 * radius, true);
  }

  /** Of a drone. */
  static PlanOutline ofDrone() {
    return circle(DroneSpec.COLLIDER.radius());
  }

  /** Of a mission pad; one that hangs is turned to its wall. */
  static PlanOutline of(MissionPad pad) {
    return new PlanOutline(
        pad.surface().wall() ? HANGING : MissionPad.EDGE, MissionPad.EDGE, false);
  }

  /** Of an obstacle. */
  static PlanOutline of(Shape shape) {
    Vec3 size = Footprint.size(shape);
    return new PlanOutline(size.x(), size.y(), shape instanceof Shape.Cylinder);
  }

  /**
   * Whether it is there at a place of the floor.
   *
   * @param margin by how much it is taken larger [m]
   */
  boolean covers(Vec3 place, Placement placement, double margin) {
    Vec3 own = placement.toOwn(place);
    if (round) {
      return Math.hypot(own.x(), own.y()) <= width / 2 + margin;
    }
    return Math.abs(own.x()) <= depth / 2 + margin && Math.abs(own.y()) <= width / 2 + margin;
  }

  /** How far it reaches from its middle [m]. */
  double reach() {
    return round ? width / 2 : Math.hypot(depth, width) / 2;
  }

  /** The corners of a rectangle, or the ends of a circle along the room's axes. */
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
