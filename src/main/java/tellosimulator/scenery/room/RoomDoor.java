package tellosimulator.scenery.room;

import java.util.List;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.TextureRegion;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.room.Face.Area;
import tellosimulator.scenery.texture.ProceduralTexture;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;

/**
 * The door of a calm room, at the right end of its front wall, by which people tell how large the
 * room is. It is flat: painted on the wall. A room that is too small for it has none. Decided: all
 * of it, by eye; sizes as of most doors.
 */
final class RoomDoor {

  /** Of the door with its frame [m]. */
  private static final double WIDTH = 1.0;

  private static final double HEIGHT = 2.1;

  /** From the door to the room's corner, and to the ceiling at least [m]. */
  private static final double CLEARANCE = 0.3;

  private static final double FRAME = 0.07;

  /** The edge of the leaf [m]. */
  private static final double GAP = 0.008;

  /** From the edge of the leaf, and from its rails' middles, to its inset panels [m]. */
  private static final double STILE = 0.13;

  /** Width of the bevel around a panel [m]. */
  private static final double BEVEL = 0.018;

  private static final double HANDLE_HEIGHT = 1.03;

  private static final int SIZE = 256;

  private static final Rgb WHITE = Rgb.of(0xf1eee8);
  private static final Rgb LEAF = Rgb.of(0xd9c7a8);
  private static final Rgb HANDLE = Rgb.of(0x54565a);

  private static final Texture TEXTURE = ProceduralTexture.of(SIZE, () -> RoomDoor::texel);

  private RoomDoor() {}

  /** The door, room frame; nothing if it does not fit in. */
  static List<Part> parts(Room room) {
    Face wall = Face.of(room, Surface.FRONT_WALL);
    if (wall.width() < WIDTH + 2 * CLEARANCE || wall.height() < HEIGHT + CLEARANCE) {
      return List.of();
    }
    Area area = new Area(wall.width() / 2 - CLEARANCE - WIDTH, 0, WIDTH, HEIGHT);
    Mesh mesh = new MeshBuilder().quad(wall.quad(area), TextureRegion.unwrapped(SIZE)).build();
    return List.of(new Part(mesh, TEXTURE, Shading.DECAL));
  }

  private static int texel(int x, int y) {
    double across = ((x + 0.5) / SIZE - 0.5) * WIDTH;
    double above = (1 - (y + 0.5) / SIZE) * HEIGHT;
    double inLeaf = Math.min(WIDTH / 2 - Math.abs(across), HEIGHT - above) - FRAME;
    if (inLeaf < 0) {
      return (inLeaf > -FRAME + 0.008 ? WHITE : WHITE.shaded(0.8)).argb();
    }
    if (inLeaf < GAP) {
      return LEAF.shaded(0.5).argb();
    }
    if (isHandle(across, above)) {
      return HANDLE.argb();
    }
    return leaf(inLeaf, above).argb();
  }

  private static boolean isHandle(double across, double above) {
    double fromEdge = across + WIDTH / 2 - FRAME;
    return fromEdge > 0.05
        && fromEdge < 0.17
        && Math.abs(above - HANDLE_HEIGHT) < (fromEdge < 0.08 ? 0.05 : 0.014);
  }

  /** Two inset panels, one above the other. */
  private static Rgb leaf(double inLeaf, double above) {
    double fromRail = Math.min(Math.abs(above - HANDLE_HEIGHT), above);
    double inPanel = Math.min(inLeaf, fromRail) - STILE;
    return inPanel < 0 ? LEAF : LEAF.shaded(inPanel < BEVEL ? 0.8 : 0.95);
  }
}
