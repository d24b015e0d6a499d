package tellosimulator.world;

import tellosimulator.math.Vec3;

/** Tests whether objects are inside a room or on a surface. */
public final class Footprint {

  /** Overhang that still counts as inside [m]. Decided: it covers rounding errors. */
  private static final double TOLERANCE = 1e-3;

  private Footprint() {}

  /** Whether an obstacle is entirely inside the room. */
  public static boolean inside(Obstacle obstacle, Room room) {
    return betweenWalls(obstacle, room) && underCeiling(obstacle, room);
  }

  /** Whether no part of an obstacle is behind a wall. */
  public static boolean betweenWalls(Obstacle obstacle, Room room) {
    Vec3 foot = obstacle.foot();
    Vec3 half = obstacle.shape().size().times(0.5);
    boolean round = obstacle.shape().round();
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

  /** Whether a mission pad is entirely on its surface. */
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
   * Returns whether an object is on a surface.
   *
   * @param place the object's middle (x along the surface, y upwards) and half its size (z) [m]
   */
  private static boolean inside(Surface surface, Vec3 place, Room room) {
    double half = place.z() - TOLERANCE;
    boolean upInside =
        surface.wall()
            ? place.y() >= half && place.y() <= room.height() - half
            : Math.abs(place.y()) <= room.depth() / 2 - half;
    return Math.abs(place.x()) <= room.lengthOf(surface) / 2 - half && upInside;
  }

  /** Whether a point is inside the room. */
  public static boolean inside(Vec3 place, Room room) {
    return Math.abs(place.x()) <= room.depth() / 2
        && Math.abs(place.y()) <= room.width() / 2
        && place.z() >= 0
        && place.z() <= room.height();
  }
}
