package tellosimulator.world;

import tellosimulator.math.Vec3;

/** Whether things are where a room has a place for them. */
public final class Footprint {

  /** What sticks out less is still inside [m]. Decided: errors of rounding. */
  private static final double TOLERANCE = 1e-3;

  private Footprint() {}

  /** Whether a whole obstacle is in the room. */
  public static boolean inside(Obstacle obstacle, Room room) {
    return betweenWalls(obstacle, room) && underCeiling(obstacle, room);
  }

  /** Whether no part of an obstacle is behind a wall. */
  public static boolean betweenWalls(Obstacle obstacle, Room room) {
    Vec3 foot = obstacle.foot();
    Vec3 half = size(obstacle.shape()).times(0.5);
    boolean round = obstacle.shape() instanceof Shape.Cylinder;
    double cosine = round ? 1 : Math.abs(StrictMath.cos(obstacle.heading()));
    double sine = round ? 0 : Math.abs(StrictMath.sin(obstacle.heading()));
    double x = cosine * half.x() + sine * half.y();
    double y = sine * half.x() + cosine * half.y();
    return Math.abs(foot.x()) + x <= room.depth() / 2 + TOLERANCE
        && Math.abs(foot.y()) + y <= room.width() / 2 + TOLERANCE;
  }

  /** Whether an obstacle reaches no higher than the ceiling. */
  public static boolean underCeiling(Obstacle obstacle, Room room) {
    return obstacle.foot().z() + obstacle.shape().height() <= room.height() + TOLERANCE;
  }

  /** Depth, width and height of a shape [m]. */
  public static Vec3 size(Shape shape) {
    if (shape instanceof Shape.Box box) {
      return new Vec3(box.depth(), box.width(), box.height());
    }
    if (shape instanceof Shape.Ring ring) {
      return new Vec3(ring.tube(), 2 * ring.reach(), ring.height());
    }
    if (shape instanceof Shape.Frame frame) {
      return new Vec3(frame.beam(), frame.width() + 2 * frame.beam(), frame.height());
    }
    return new Vec3(2 * shape.reach(), 2 * shape.reach(), shape.height());
  }

  /** Whether a whole mission pad is on its surface. */
  public static boolean inside(MissionPad pad, Room room) {
    double half =
        MissionPad.EDGE
            / 2
            * (Math.abs(StrictMath.cos(pad.rotation())) + Math.abs(StrictMath.sin(pad.rotation())));
    return inside(pad.surface(), new Vec3(pad.along(), pad.height(), half), room);
  }

  /** Whether the middle of a poster is on its surface. */
  public static boolean inside(Poster poster, Room room) {
    return inside(poster.surface(), new Vec3(poster.along(), poster.height(), 0), room);
  }

  /**
   * Whether something is on a surface.
   *
   * @param place its middle along the surface and up, and half its size
   */
  private static boolean inside(Surface surface, Vec3 place, Room room) {
    double half = place.z() - TOLERANCE;
    boolean upInside =
        surface.wall()
            ? place.y() >= half && place.y() <= room.height() - half
            : Math.abs(place.y()) <= room.depth() / 2 - half;
    return Math.abs(place.x()) <= room.lengthOf(surface) / 2 - half && upInside;
  }

  /** Whether a place is in the room. */
  public static boolean inside(Vec3 place, Room room) {
    return Math.abs(place.x()) <= room.depth() / 2
        && Math.abs(place.y()) <= room.width() / 2
        && place.z() >= 0
        && place.z() <= room.height();
  }
}
