package tellosimulator.world;

import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

/**
 * A printed card that drones recognise. The origin of a pad's frame is the middle of the card. Its
 * x axis points in the direction of the printed rocket, y to the rocket's left, and z out of the
 * card. Documented: Mission Pad User Guide. Immutable.
 *
 * @param id the printed number, 1 to 8
 * @param surface the surface on which the pad lies or hangs: the floor or a wall
 * @param along the distance from the surface's middle to the pad's middle [m], to the right as seen
 *     by a viewer in front of the surface; for a viewer of the floor, the front wall is at the top
 * @param height the height of the pad's middle above the floor [m]; for a pad on the floor, the
 *     distance from the floor's middle towards the front wall
 * @param rotation the direction of the rocket [rad], counter-clockwise as seen by the viewer; 0 is
 *     upwards on a wall, and along the room's x axis on the floor
 */
public record MissionPad(int id, Surface surface, double along, double height, double rotation) {

  /** Highest id. Documented: Mission Pad User Guide. */
  public static final int LAST_ID = 8;

  /** Side length of a pad [m]. Assumed: estimated from pictures with a drone on the pad. */
  public static final double EDGE = 0.2;

  public MissionPad {
    if (id < 1 || id > LAST_ID) {
      throw new IllegalArgumentException("pad is " + id + ", but must be from 1 to " + LAST_ID);
    }
    if (surface == Surface.CEILING) {
      throw new IllegalArgumentException("pads lie on the floor or hang on walls");
    }
  }

  /**
   * Creates a pad on the floor.
   *
   * @param place the place on the floor, in the room frame [m]
   * @param heading the heading of the rocket [rad], counter-clockwise seen from above
   */
  public static MissionPad onFloor(int id, Vec3 place, double heading) {
    return new MissionPad(id, Surface.FLOOR, -place.y(), place.x(), heading);
  }

  /** Returns a copy of this pad at another place on its surface. */
  public MissionPad movedTo(double newAlong, double newHeight) {
    return new MissionPad(id, surface, newAlong, newHeight, rotation);
  }

  /** Returns the pose of the pad's frame in a room. */
  public Pose pose(Room room) {
    Pose upright = surface.pose(room, along, height);
    Attitude turned = Attitude.ofHeading(rotation);
    return new Pose(upright.position(), upright.attitude().after(turned));
  }
}
