package tellosimulator.world;

import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

/**
 * A printed card that drones recognise. Its frame: origin in its middle, x where the rocket points,
 * y to the rocket's left, z out of the card. Documented: Mission Pad User Guide. Immutable.
 *
 * @param id 1 to 8, which is printed on it
 * @param surface on which it lies or hangs: the floor or a wall
 * @param along from the surface's middle to the pad's, to the right as one sees it who looks at it;
 *     the front wall is the upper end of the floor [m]
 * @param height of the pad's middle above the floor [m]; on the floor, from its middle upwards
 * @param rotation where the rocket points [rad], counter-clockwise as one sees it; 0 is upwards,
 *     and on the floor along the room's x
 */
public record MissionPad(int id, Surface surface, double along, double height, double rotation) {

  /** Ids that there are. Documented: Mission Pad User Guide. */
  public static final int LAST_ID = 8;

  /** Edge of a pad [m]. Assumed: by eye, from pictures with a drone on it. */
  public static final double EDGE = 0.2;

  /** From a pad that lies to one that hangs: its x axis points up, its z axis back. */
  private static final Attitude HANGING = new Attitude(Math.sqrt(0.5), 0, -Math.sqrt(0.5), 0);

  public MissionPad {
    if (id < 1 || id > LAST_ID) {
      throw new IllegalArgumentException("pad is " + id + ", but must be from 1 to " + LAST_ID);
    }
    if (surface == Surface.CEILING) {
      throw new IllegalArgumentException("pads lie on the floor or hang on walls");
    }
  }

  /**
   * A pad on the floor.
   *
   * @param place on the floor, room frame [m]
   * @param heading of the rocket [rad], counter-clockwise seen from above
   */
  public static MissionPad onFloor(int id, Vec3 place, double heading) {
    return new MissionPad(id, Surface.FLOOR, -place.y(), place.x(), heading);
  }

  /** The same elsewhere on its surface. */
  public MissionPad movedTo(double newAlong, double newHeight) {
    return new MissionPad(id, surface, newAlong, newHeight, rotation);
  }

  /** Where its frame is in a room. */
  public Pose pose(Room room) {
    Attitude turned = Attitude.ofHeading(rotation);
    if (surface == Surface.FLOOR) {
      return new Pose(new Vec3(height, -along, 0), turned);
    }
    Attitude facing = Attitude.ofHeading(surface.heading());
    Vec3 middle = facing.toRoom(new Vec3(room.distanceTo(surface), -along, height));
    return new Pose(middle, facing.after(HANGING).after(turned));
  }
}
