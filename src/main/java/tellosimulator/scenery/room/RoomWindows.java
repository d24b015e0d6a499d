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
import tellosimulator.scenery.texture.ProceduralTexture;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;

/**
 * The windows of a calm room, side by side in its left wall, and the daylight that falls through
 * them on the floor along the key light. They are flat: painted on the wall. A room that is too low
 * for them has none. Decided: all of it, by eye; sizes as in a classroom.
 */
final class RoomWindows {

  /** Of a window with its frame [m]. */
  private static final double WIDTH = 1.2;

  private static final double HEIGHT = 1.25;

  /** Of its lower edge above the floor [m]. */
  private static final double SILL = 0.95;

  /** From its upper edge to the ceiling at least [m]. */
  private static final double LINTEL = 0.2;

  /** From the middle of a window to the next one's, at least and at most [m]. */
  private static final double LEAST_SPACING = 1.55;

  private static final double MOST_SPACING = 2;

  /** Of the frame [m]; the bars have the same. */
  private static final double FRAME = 0.05;

  /** Of the middle of the horizontal bar above the lower edge [m]. */
  private static final double CROSSBAR = 0.85;

  /** How far the sill board stands out at either side, and how high it is [m]. */
  private static final double BOARD = 0.045;

  /** Below the board [m]. */
  private static final double SHADE = 0.1;

  private static final int SIZE = 256;
  private static final int LIGHT_SIZE = 64;

  private static final Rgb WHITE = Rgb.of(0xf6f4ef);
  private static final Rgb EDGE = Rgb.of(0xb9b5ac);
  private static final Rgb ZENITH = Rgb.of(0xb4d0e6);
  private static final Rgb HORIZON = Rgb.of(0xeef4f5);
  private static final Rgb DAYLIGHT = Rgb.of(0xfff3d6);

  /** Opacity of the light on the floor. */
  private static final double BRIGHTEST = 0.42;

  private static final Texture WINDOW = ProceduralTexture.of(SIZE, () -> RoomWindows::window);
  private static final Texture LIGHT = ProceduralTexture.of(LIGHT_SIZE, () -> RoomWindows::light);

  private RoomWindows() {}

  /** The windows and their light, room frame; nothing if they do not fit in. */
  static List<Part> parts(Room room) {
    Face wall = Face.of(room, Surface.LEFT_WALL);
    int count = count(wall.width());
    if (count == 0 || room.height() < SILL + HEIGHT + LINTEL) {
      return List.of();
    }
    double spacing = Math.min(MOST_SPACING, wall.width() / count);
    MeshBuilder windows = new MeshBuilder();
    MeshBuilder light = new MeshBuilder();
    for (int i = 0; i < count; i++) {
      double middle = (i - (count - 1) / 2.0) * spacing;
      Area painted =
          new Area(
              middle - WIDTH / 2 - BOARD,
              SILL - BOARD - SHADE,
              WIDTH + 2 * BOARD,
              HEIGHT + BOARD + SHADE);
      windows.quad(wall.quad(painted), TextureRegion.unwrapped(SIZE));
      light.polygon(onFloor(room, wall, new Area(middle - WIDTH / 2, SILL, WIDTH, HEIGHT)));
    }
    return List.of(
        new Part(light.build(), LIGHT, Shading.DECAL),
        new Part(windows.build(), WINDOW, Shading.DECAL));
  }

  /**
   * As many on either side of the wall's middle, where posters and pads are hung and at least a
   * quarter of a metre is free; or one alone.
   */
  private static int count(double wallWidth) {
    int pairs = (int) Math.floor(wallWidth / (2 * LEAST_SPACING));
    return pairs == 0 && wallWidth >= LEAST_SPACING ? 1 : 2 * pairs;
  }

  /** Where the light through a part of the wall falls on the floor. */
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

  /** A texel of a window with its board. */
  private static int window(int x, int y) {
    double across = ((x + 0.5) / SIZE - 0.5) * (WIDTH + 2 * BOARD);
    double above = HEIGHT - (y + 0.5) / SIZE * (HEIGHT + BOARD + SHADE);
    if (above < -BOARD) {
      double near = 1 + (above + BOARD) / SHADE;
      return Math.abs(across) < WIDTH / 2 + BOARD ? Rgb.BLACK.argb(0.22 * near * near) : 0;
    }
    if (above < 0) {
      return (above > -0.3 * BOARD ? WHITE : WHITE.shaded(0.86)).argb();
    }
    double fromSide = WIDTH / 2 - Math.abs(across);
    if (fromSide < 0) {
      return 0;
    }
    return glazed(across, above, Math.min(fromSide, Math.min(above, HEIGHT - above)));
  }

  /** A texel of frame, bars or glass. */
  private static int glazed(double across, double above, double fromEdge) {
    double fromBar = Math.min(Math.abs(across), Math.abs(above - CROSSBAR)) - FRAME / 2;
    double inGlass = Math.min(fromEdge - FRAME, fromBar);
    if (inGlass < 0) {
      return (fromEdge < 0.008 ? EDGE : WHITE).argb();
    }
    Rgb sky = HORIZON.towards(ZENITH, above / HEIGHT);
    double depth = Math.max(0, 1 - inGlass / 0.03);
    return sky.towards(EDGE, 0.75 * depth).argb();
  }

  /** A texel of the light, with the shadows of frame and bars. */
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
