package tellosimulator.scenery.room;

import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.MeshBuilder.Quad;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;

/**
 * One of the six sides of a room, seen from inside. Coordinates on it are metres to the right of
 * its middle, and metres upwards: on a wall from the floor, on floor and ceiling from their middle.
 *
 * @param origin of its coordinates, room frame [m]
 * @param right unit vector
 * @param up unit vector; on the floor to the front wall, on the ceiling to the back wall
 * @param width metres
 * @param height metres
 * @param bottom where its lower edge is, upwards from the origin [m]
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

  /** All of it. */
  Quad quad() {
    return quad(area());
  }

  /** Where all of it is. */
  Area area() {
    return new Area(-width / 2, bottom, width, height);
  }

  /** A horizontal band as wide as the face. */
  Quad band(double lower, double bandHeight) {
    return quad(new Area(-width / 2, lower, width, bandHeight));
  }

  /**
   * A rectangle on a face.
   *
   * @param left of its left edge [m]
   * @param lower of its lower edge [m]
   * @param width metres
   * @param height metres
   */
  record Area(double left, double lower, double width, double height) {

    /** Of its upper edge [m]. */
    double upper() {
      return lower + height;
    }

    /** What it shares with another one; without width or height if that is nothing. */
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
