package tellosimulator.scenery.room;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.scenery.Finish;
import tellosimulator.scenery.Part;
import tellosimulator.scenery.Texture;
import tellosimulator.scenery.room.Quads.Patch;
import tellosimulator.world.Decor;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;
import tellosimulator.world.Walls;

/**
 * The inside of a room: floor, walls and ceiling, and what is painted on them. It has no outside:
 * where a wall stands between the camera and the room, one does not see it. It keeps the pictures
 * of the latest room. For any thread.
 */
public final class Interior {

  /** Brightness of plain walls across the depth; so one sees the corners. Decided: by eye. */
  private static final double SHADE = 0.955;

  /** The wall's uppermost pixels, of which a plain ceiling is. */
  private static final Patch CEILING = new Patch(0, 0, 1, 0.001);

  private final Gallery gallery = new Gallery();
  private final Latest<Double, Texture> plainFloor = new Latest<>(PlainSurface::floor);
  private final Latest<Double, Texture> parquet = new Latest<>(Parquet::texture);
  private final Latest<Double, Texture> plainWall =
      new Latest<>(height -> PlainSurface.wall(height, 1));
  private final Latest<Double, Texture> shadedWall =
      new Latest<>(height -> PlainSurface.wall(height, SHADE));

  /** The parts of a room, room frame, in the order in which they are drawn. */
  public synchronized List<Part> parts(Room room, Decor decor) {
    boolean plain = decor.walls() == Walls.PLAIN;
    List<Part> parts = new ArrayList<>(plain ? plain(room, decor) : textured(room, decor));
    parts.add(MetreMarks.part(room, decor.walls()));
    parts.addAll(gallery.parts(room, decor.posters()));
    return List.copyOf(parts);
  }

  private List<Part> plain(Room room, Decor decor) {
    Face floor = Face.of(room, Surface.FLOOR);
    Quads across =
        new Quads()
            .add(Face.of(room, Surface.FRONT_WALL).whole(), Patch.WHOLE)
            .add(Face.of(room, Surface.BACK_WALL).whole(), Patch.WHOLE)
            .add(Face.of(room, Surface.CEILING).whole(), CEILING);
    Quads along =
        new Quads()
            .add(Face.of(room, Surface.LEFT_WALL).whole(), Patch.WHOLE)
            .add(Face.of(room, Surface.RIGHT_WALL).whole(), Patch.WHOLE);
    return List.of(
        painted(
            new Quads().add(floor.whole(), centred(floor, decor.grid(), 0.5)),
            plainFloor.of(decor.grid())),
        painted(across, plainWall.of(room.height())),
        painted(along, shadedWall.of(room.height())));
  }

  private List<Part> textured(Room room, Decor decor) {
    Face floor = Face.of(room, Surface.FLOOR);
    Face ceiling = Face.of(room, Surface.CEILING);
    int cells = Parquet.cells(decor.grid());
    List<Part> parts = new ArrayList<>();
    parts.add(
        painted(
            new Quads().add(floor.whole(), centred(floor, cells * decor.grid(), 0.5 / cells)),
            parquet.of(decor.grid())));
    parts.add(
        painted(
            new Quads().add(ceiling.whole(), centred(ceiling, Wallpaper.TILE, 0)),
            Wallpaper.PANELS.texture()));
    parts.add(papered(Face.of(room, Surface.FRONT_WALL), Wallpaper.BRICKS.texture()));
    parts.add(papered(Face.of(room, Surface.BACK_WALL), Wallpaper.HEXAGONS.texture()));
    parts.add(papered(Face.of(room, Surface.LEFT_WALL), Wallpaper.BOARDS.texture()));
    parts.add(papered(Face.of(room, Surface.RIGHT_WALL), Wallpaper.TRIANGLES.texture()));
    parts.addAll(Trim.parts(room));
    return parts;
  }

  private static Part papered(Face wall, Texture paper) {
    double across = wall.width() / Wallpaper.TILE;
    double down = wall.height() / Wallpaper.TILE;
    Patch tiles = new Patch(firstEdge(across, 0), Math.ceil(down) - down, across, down);
    return painted(new Quads().add(wall.whole(), tiles), paper);
  }

  private static Part painted(Quads quads, Texture texture) {
    return new Part(quads.mesh(), texture, Finish.PAINTED);
  }

  /**
   * So many tiles on floor or ceiling that the middle of the face is at a place of a tile.
   *
   * @param tile its edge [m]
   * @param place in parts of the tile from its left and from its top
   */
  private static Patch centred(Face face, double tile, double place) {
    double across = face.width() / tile;
    double down = face.height() / tile;
    return new Patch(firstEdge(across, place), firstEdge(down, place), across, down);
  }

  /** Where in a tile the first edge of all is, from 0 to 1. */
  private static double firstEdge(double tiles, double place) {
    double edge = place - tiles / 2;
    return edge - Math.floor(edge);
  }
}
