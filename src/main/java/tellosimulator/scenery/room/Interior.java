package tellosimulator.scenery.room;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Finish;
import tellosimulator.scenery.Part;
import tellosimulator.scenery.Texture;
import tellosimulator.scenery.room.Quads.Patch;
import tellosimulator.scenery.room.Quads.Quad;
import tellosimulator.world.Decor;
import tellosimulator.world.Room;

/**
 * The inside of a room: floor, walls and ceiling, and what is painted on them. It has no outside:
 * where a wall stands between the camera and the room, one does not see it. For any thread.
 */
public final class Interior {

  /** Brightness of the walls across the depth; so one sees the corners. Decided: by eye. */
  private static final double SHADE = 0.955;

  private Interior() {}

  /** The parts of a room, room frame, in the order in which they are drawn. */
  public static List<Part> parts(Room room, Decor decor) {
    List<Part> parts = new ArrayList<>();
    parts.add(floor(room, decor.grid()));
    parts.addAll(walls(room));
    parts.add(MetreMarks.part(room));
    return List.copyOf(parts);
  }

  /** The lines go through the origin of the room frame, which is in the middle of a tile. */
  private static Part floor(Room room, double grid) {
    Quad quad =
        new Quad(
            new Vec3(-room.depth() / 2, room.width() / 2, 0),
            new Vec3(0, -room.width(), 0),
            new Vec3(room.depth(), 0, 0));
    Patch tiles = centred(room.width() / grid, room.depth() / grid);
    return new Part(new Quads().add(quad, tiles).mesh(), PlainSurface.floor(grid), Finish.PAINTED);
  }

  /** So many tiles that the middle of all is in the middle of a tile. */
  private static Patch centred(double across, double down) {
    return new Patch(firstEdge(across), firstEdge(down), across, down);
  }

  private static double firstEdge(double tiles) {
    double edge = 0.5 - tiles / 2;
    return edge - Math.floor(edge);
  }

  private static List<Part> walls(Room room) {
    Vec3 up = Vec3.UP.times(room.height());
    Vec3 depth = new Vec3(room.depth(), 0, 0);
    Vec3 width = new Vec3(0, room.width(), 0);
    Vec3 backRight = depth.plus(width).times(-0.5);
    Vec3 frontLeft = depth.plus(width).times(0.5);
    Texture bright = PlainSurface.wall(room.height(), 1);
    Texture dim = PlainSurface.wall(room.height(), SHADE);
    Quads across =
        new Quads()
            .add(new Quad(frontLeft, width.times(-1), up), Patch.WHOLE)
            .add(new Quad(backRight, width, up), Patch.WHOLE)
            .add(new Quad(backRight.plus(up), width, depth), new Patch(0, 0, 1, 0.001));
    Quads along =
        new Quads()
            .add(new Quad(backRight.plus(width), depth, up), Patch.WHOLE)
            .add(new Quad(frontLeft.minus(width), depth.times(-1), up), Patch.WHOLE);
    return List.of(
        new Part(across.mesh(), bright, Finish.PAINTED),
        new Part(along.mesh(), dim, Finish.PAINTED));
  }
}
