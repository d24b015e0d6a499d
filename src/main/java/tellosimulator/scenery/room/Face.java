package tellosimulator.scenery.room;

import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.MeshBuilder.Quad;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;

/**
 * One of the six sides of a room, seen from inside. Its coordinates are in metres, to the right and
 * upwards. Horizontally, they are measured from the middle. Vertically, they are measured from the
 * floor on a wall, and from the middle on the floor and the ceiling.
 *
 * @param origin origin of the face's coordinates, in the room frame [m]
 * @param right unit vector to the right, in the room frame
 * @param up unit vector upwards, in the room frame; on the floor it points towards the front wall,
 *     on the ceiling towards the back wall
 * @param width width in metres
 * @param height height in metres
 * @param bottom position of the lower edge, upwards from the origin [m]
 */
record Face(Vec3 origin, Vec3 right, Vec3 up, double width, double height, double bottom) {

  static Face of(Room room, Surface surface) {
    return switch (surface) {
      case FLOOR -> level(Vec3.ZERO, new Vec3(1, 0, 0), room);
      case CEILING -> level(Vec3.UP.times(room.height()), new Vec3(-1, 0, 0), room);
      case FRONT_WALL -> wall(new Vec3(room.depth() / 2, 0, 0), room.width(), room);
      case BACK_WALL -> wall(new Vec3(-room.depth() / 2, 0, 0), room.width(), room);
      case LEFT_WALL -> wall(new Vec3(0, room.width() / 2, 0), room.depth(), room);
      case RIGHT_WALL -> wall(new Vec3(0, -room.width() / 2, 0), room.depth(), room);
    };
  }

  private static Face level(Vec3 origin, Vec3 up, Room room) {
    return new Face(origin, new Vec3(0, -1, 0), up, room.width(), room.depth(), -room.depth() / 2);
  }

  private static Face wall(Vec3 foot, double width, Room room) {
    Vec3 ahead = foot.normalized();
    return new Face(foot, ahead.cross(Vec3.UP), Vec3.UP, width, room.height(), 0);
  }

  /** Returns the rectangle of the whole face. */
  Quad quad() {
    return quad(area());
  }

  /** Returns the whole face as an area. */
  Area area() {
    return new Area(-width / 2, bottom, width, height);
  }

  /** Returns a horizontal band that is as wide as the face. */
  Quad band(double lower, double bandHeight) {
    return quad(new Area(-width / 2, lower, width, bandHeight));
  }

  /**
   * A rectangle on a face.
   *
   * @param left position of the left edge [m]
   * @param lower position of the lower edge [m]
   * @param width width in metres
   * @param height height in metres
   */
  record Area(double left, double lower, double width, double height) {

    /** Returns the position of the upper edge [m]. */
    double upper() {
      return lower + height;
    }

    /**
     * Returns the intersection with another area. If there is none, the width or height of the
     * result is 0.
     */
    Area within(Area other) {
      double newLeft = Math.max(left, other.left);
      double newLower = Math.max(lower, other.lower);
      double right = Math.min(left + width, other.left + other.width);
      double newUpper = Math.min(upper(), other.upper());
      return new Area(
          newLeft, newLower, Math.max(0, right - newLeft), Math.max(0, newUpper - newLower));
    }
  }

  Quad quad(Area area) {
    Vec3 corner = origin.plusScaled(right, area.left).plusScaled(up, area.lower);
    return new Quad(corner, right.times(area.width), up.times(area.height));
  }
}
