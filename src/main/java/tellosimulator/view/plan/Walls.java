package tellosimulator.view.plan;

import java.util.Comparator;
import java.util.List;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;

/** Mission pads on the floor and at walls, as the plan shows them. */
final class Walls {

  private static final List<Surface> WALLS =
      List.of(Surface.FRONT_WALL, Surface.LEFT_WALL, Surface.BACK_WALL, Surface.RIGHT_WALL);

  private Walls() {}

  /** Where a mission pad is seen from above; one that hangs looks out of its wall. */
  static Spot spot(MissionPad pad, Room room) {
    Vec3 middle = pad.pose(room).position();
    if (!pad.surface().wall()) {
      return new Spot(middle, pad.rotation());
    }
    double out = Frames.wrapped(heading(pad.surface()) + Math.PI);
    return new Spot(middle.plus(new Vec3(Outline.HANGING / 2, 0, 0).turned(out)), out);
  }

  /** The same elsewhere: on the floor anywhere, otherwise along the walls. */
  static MissionPad moved(MissionPad pad, Spot spot, Room room) {
    if (!pad.surface().wall()) {
      return MissionPad.onFloor(pad.id(), spot.place(), spot.heading());
    }
    Surface wall = nearest(spot.place(), room);
    // to the right of who looks at the wall
    double along = -spot.place().turned(-heading(wall)).y();
    double reach = (across(wall, room) - MissionPad.EDGE) / 2;
    double kept = Math.max(-reach, Math.min(reach, along));
    return new MissionPad(pad.id(), wall, kept, pad.height(), pad.rotation());
  }

  private static Surface nearest(Vec3 place, Room room) {
    return WALLS.stream()
        .min(Comparator.comparingDouble(wall -> distance(place, wall, room)))
        .orElseThrow();
  }

  private static double distance(Vec3 place, Surface wall, Room room) {
    double ahead = place.turned(-heading(wall)).x();
    return (frontBack(wall) ? room.depth() : room.width()) / 2 - ahead;
  }

  private static double across(Surface wall, Room room) {
    return frontBack(wall) ? room.width() : room.depth();
  }

  private static boolean frontBack(Surface wall) {
    return wall == Surface.FRONT_WALL || wall == Surface.BACK_WALL;
  }

  /** Where one looks who looks at a wall. */
  private static double heading(Surface wall) {
    return WALLS.indexOf(wall) * Math.PI / 2;
  }
}
