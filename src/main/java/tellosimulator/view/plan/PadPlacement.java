package tellosimulator.view.plan;

import java.util.Comparator;
import java.util.List;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;

/** Computes the placement of mission pads on the floor and at walls, seen from above. */
final class PadPlacement {

  private static final List<Surface> WALLS =
      List.of(Surface.FRONT_WALL, Surface.LEFT_WALL, Surface.BACK_WALL, Surface.RIGHT_WALL);

  private PadPlacement() {}

  /**
   * Returns the placement of a mission pad. The heading of a hanging pad points from its wall into
   * the room.
   */
  static Placement placement(MissionPad pad, Room room) {
    Vec3 middle = pad.pose(room).position();
    if (!pad.surface().wall()) {
      return new Placement(middle, pad.rotation());
    }
    double out = Frames.wrapped(pad.surface().heading() + Math.PI);
    return new Placement(middle.plus(new Vec3(PlanOutline.HANGING / 2, 0, 0).turned(out)), out);
  }

  /**
   * Returns a mission pad moved to a placement. A hanging pad moves to the nearest wall, and keeps
   * its height and rotation.
   */
  static MissionPad moved(MissionPad pad, Placement placement, Room room) {
    if (!pad.surface().wall()) {
      return MissionPad.onFloor(pad.id(), placement.place(), placement.heading());
    }
    Surface wall = nearest(placement.place(), room);
    // to the right, as seen by an observer who faces the wall
    double along = -placement.place().turned(-wall.heading()).y();
    double reach = (room.lengthOf(wall) - MissionPad.EDGE) / 2;
    double kept = Math.max(-reach, Math.min(reach, along));
    return new MissionPad(pad.id(), wall, kept, pad.height(), pad.rotation());
  }

  private static Surface nearest(Vec3 place, Room room) {
    return WALLS.stream()
        .min(Comparator.comparingDouble(wall -> distance(place, wall, room)))
        .orElseThrow();
  }

  private static double distance(Vec3 place, Surface wall, Room room) {
    double ahead = place.turned(-wall.heading()).x();
    return room.distanceTo(wall) - ahead;
  }
}
