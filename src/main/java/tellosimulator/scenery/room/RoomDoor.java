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
 * The door of a calm room ({@code Walls.AUTO}), at the right end of the front wall. It shows people
 * how large the room is. The door is flat: it is painted on the wall. A room that is too small for
 * a door has none. Decided: the whole design, by eye; the sizes are typical of doors.
 */
final class RoomDoor {

  /** Width of the door with its frame [m]. */
  private static final double WIDTH = 1.0;

  private static final double HEIGHT = 2.1;

  /** Distance from the door to the corner of the room, and minimum distance to the ceiling [m]. */
  private static final double CLEARANCE = 0.3;

  private static final double FRAME = 0.07;

  /** Width of the dark edge around the door leaf [m]. */
  private static final double GAP = 0.008;

  /**
   * Distance of the inset panels from the edge of the door leaf, and from the centre lines of its
   * rails [m].
   */
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

  /** Returns the door in the room frame, or an empty list if it does not fit. */
  static List<Part> parts(Room room) {
    Face wall = Face.of(room, Surface.FRONT_WALL);
    if (wall.width() < WIDTH + 2 * CLEARANCE || wall.height() < HEIGHT + CLEARANCE) {
      return List.of();
    }
    Area area = new Area(wall.width() / 2 - CLEARANCE - WIDTH, 0, WIDTH, HEIGHT);
    Mesh mesh = new MeshBuilder().quad(wall.quad(area), TextureRegion.unwrapped(TEXTURE)).build();
    return List.of(new Part(mesh, TEXTURE, Shading.PANEL));
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

  /**
   * Returns the colour of the door leaf at a place. The leaf has two inset panels, one above the
   * other.
   *
   * @param inLeaf distance from the leaf's left, right or upper edge, whichever is nearest [m]
   * @param above height above the floor [m]
   */
  private static Rgb leaf(double inLeaf, double above) {
    double fromRail = Math.min(Math.abs(above - HANDLE_HEIGHT), above);
    double inPanel = Math.min(inLeaf, fromRail) - STILE;
    return inPanel < 0 ? LEAF : LEAF.shaded(inPanel < BEVEL ? 0.8 : 0.95);
  }
}
