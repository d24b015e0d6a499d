package tellosimulator.scenery.room;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Lights;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.TextureRegion;
import tellosimulator.scenery.mesh.MeshBuilder.Vertex;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.PolygonClip;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.room.Face.Area;
import tellosimulator.scenery.texture.Falloff;
import tellosimulator.scenery.texture.ProceduralTexture;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;

/**
 * The windows of a calm room ({@code Walls.AUTO}), and the daylight on its floor. The windows are
 * side by side in the left wall. The daylight falls through them in the direction of the key light.
 * The windows are flat: they are painted on the wall. A room that is too low for windows has none.
 * Decided: the whole design, by eye; the sizes are typical of classroom windows.
 */
final class RoomWindows {

  /** Width of a window with its frame [m]. */
  private static final double WIDTH = 1.2;

  private static final double HEIGHT = 1.25;

  /** Height of the lower edge of a window above the floor [m]. */
  private static final double SILL = 0.95;

  /** Minimum distance from the upper edge of a window to the ceiling [m]. */
  private static final double LINTEL = 0.2;

  /** Minimum distance between the centres of adjacent windows [m]. */
  private static final double LEAST_SPACING = 1.55;

  private static final double MOST_SPACING = 2;

  /** Width of the frame and of the bars [m]. */
  private static final double FRAME = 0.05;

  /** Height of the centre line of the horizontal bar above the lower edge of the window [m]. */
  private static final double CROSSBAR = 0.85;

  /** Overhang of the sill board on either side, and thickness of the board [m]. */
  private static final double BOARD = 0.045;

  /** Height of the shadow below the sill board [m]. */
  private static final double SHADE = 0.1;

  private static final int SIZE = 256;
  private static final int BOARD_SIZE = 16;
  private static final int LIGHT_SIZE = 64;

  private static final Rgb WHITE = Rgb.of(0xf6f4ef);
  private static final Rgb EDGE = Rgb.of(0xb9b5ac);
  private static final Rgb ZENITH = Rgb.of(0xb4d0e6);
  private static final Rgb HORIZON = Rgb.of(0xeef4f5);
  private static final Rgb DAYLIGHT = Rgb.of(0xfff3d6);

  /** Maximum opacity of the light on the floor. */
  private static final double BRIGHTEST = 0.42;

  private static final Texture WINDOW = ProceduralTexture.of(SIZE, () -> RoomWindows::window);
  private static final Texture SILL_BOARD =
      ProceduralTexture.of(
          BOARD_SIZE, () -> (x, y) -> (y < 0.3 * BOARD_SIZE ? WHITE : WHITE.shaded(0.86)).argb());
  private static final Texture UNDER_SILL = Falloff.texture(Rgb.BLACK, 0.22);

  /** The region that shows a falloff upside down, so that it is darkest at the upper edge. */
  private static final TextureRegion UNDER =
      new TextureRegion(
          0, Falloff.REGION.top() + Falloff.REGION.height(), 1, -Falloff.REGION.height());

  private static final Texture LIGHT = ProceduralTexture.of(LIGHT_SIZE, () -> RoomWindows::light);

  private RoomWindows() {}

  /** Returns the windows and their light in the room frame, or an empty list if they do not fit. */
  static List<Part> parts(Room room) {
    Face wall = Face.of(room, Surface.LEFT_WALL);
    int count = count(wall.width());
    if (count == 0 || room.height() < SILL + HEIGHT + LINTEL) {
      return List.of();
    }
    double spacing = Math.min(MOST_SPACING, wall.width() / count);
    MeshBuilder windows = new MeshBuilder();
    MeshBuilder boards = new MeshBuilder();
    MeshBuilder shades = new MeshBuilder();
    MeshBuilder light = new MeshBuilder();
    for (int i = 0; i < count; i++) {
      double middle = (i - (count - 1) / 2.0) * spacing;
      Area glazed = new Area(middle - WIDTH / 2, SILL, WIDTH, HEIGHT);
      Area board = new Area(glazed.left() - BOARD, SILL - BOARD, WIDTH + 2 * BOARD, BOARD);
      windows.quad(wall.quad(glazed), TextureRegion.unwrapped(WINDOW));
      boards.quad(wall.quad(board), TextureRegion.unwrapped(SILL_BOARD));
      shades.quad(
          wall.quad(new Area(board.left(), board.lower() - SHADE, board.width(), SHADE)), UNDER);
      light.polygon(onFloor(room, wall, glazed));
    }
    return List.of(
        new Part(windows.build(), WINDOW, Shading.PANEL),
        new Part(boards.build(), SILL_BOARD, Shading.PANEL),
        new Part(light.build(), LIGHT, Shading.DECAL),
        new Part(shades.build(), UNDER_SILL, Shading.DECAL));
  }

  /**
   * Returns the number of windows: the same number on either side of the wall's middle, or a single
   * window. If there are several, at least a quarter of a metre stays free in the middle of the
   * wall, where posters and pads hang.
   */
  private static int count(double wallWidth) {
    int pairs = (int) Math.floor(wallWidth / (2 * LEAST_SPACING));
    return pairs == 0 && wallWidth >= LEAST_SPACING ? 1 : 2 * pairs;
  }

  /** Returns the area of the floor on which light falls through an opening in the wall. */
  private static List<Vertex> onFloor(Room room, Face wall, Area opening) {
    List<Vertex> corners = new ArrayList<>();
    double right = opening.left() + opening.width();
    corners.add(onFloor(wall, opening.left(), opening.lower(), 0, 1));
    corners.add(onFloor(wall, opening.left(), opening.upper(), 0, 0));
    corners.add(onFloor(wall, right, opening.upper(), 1, 0));
    corners.add(onFloor(wall, right, opening.lower(), 1, 1));
    return PolygonClip.inside(corners, room.depth() / 2, room.width() / 2);
  }

  private static Vertex onFloor(Face wall, double across, double up, double u, double v) {
    Vec3 place = wall.origin().plusScaled(wall.right(), across).plusScaled(wall.up(), up);
    return new Vertex(Lights.onFloor(place), Vec3.UP, u, v);
  }

  /** Returns a texel of the frame, the bars or the glass. */
  private static int window(int x, int y) {
    double across = ((x + 0.5) / SIZE - 0.5) * WIDTH;
    double above = (1 - (y + 0.5) / SIZE) * HEIGHT;
    double fromEdge = Math.min(WIDTH / 2 - Math.abs(across), Math.min(above, HEIGHT - above));
    double fromBar = Math.min(Math.abs(across), Math.abs(above - CROSSBAR)) - FRAME / 2;
    double inGlass = Math.min(fromEdge - FRAME, fromBar);
    if (inGlass < 0) {
      return (fromEdge < 0.008 ? EDGE : WHITE).argb();
    }
    Rgb sky = HORIZON.towards(ZENITH, above / HEIGHT);
    double depth = Math.max(0, 1 - inGlass / 0.03);
    return sky.towards(EDGE, 0.75 * depth).argb();
  }

  /** Returns a texel of the light on the floor, with the shadows of the frame and the bars. */
  private static int light(int x, int y) {
    double across = ((x + 0.5) / LIGHT_SIZE - 0.5) * WIDTH;
    double above = (1 - (y + 0.5) / LIGHT_SIZE) * HEIGHT;
    double fromEdge =
        Math.min(WIDTH / 2 - Math.abs(across), Math.min(above, HEIGHT - above)) - FRAME / 2;
    double fromBar = Math.min(Math.abs(across), Math.abs(above - CROSSBAR));
    double soft = 0.07;
    double edge = Math.max(0, Math.min(1, fromEdge / soft));
    double bar = Math.max(0.25, Math.min(1, fromBar / soft));
    return DAYLIGHT.argb(BRIGHTEST * edge * bar);
  }
}
