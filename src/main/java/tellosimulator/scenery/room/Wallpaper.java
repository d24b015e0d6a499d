package tellosimulator.scenery.room;

import java.util.Locale;
import java.util.function.Supplier;
import tellosimulator.scenery.Texture;
import tellosimulator.scenery.paint.PreparedTile;
import tellosimulator.scenery.paint.Tile;
import tellosimulator.scenery.paint.Tile.Look;

/**
 * The patterns on walls, ceiling and floor. They come with the program as resources, because at its
 * start painting takes longer than all else that the first picture needs.
 */
enum Wallpaper {
  BRICKS(Wallpaper.SIZE, Brickwork::look),
  HEXAGONS(Wallpaper.SIZE, Hexagons::look),
  BOARDS(Wallpaper.SIZE, Boards::look),
  TRIANGLES(Wallpaper.SIZE, Triangles::look),
  PANELS(CeilingPanels.SIZE, CeilingPanels::look),
  PARQUET(Parquet.SIZE, Parquet::look);

  /** Edge of the square that repeats [m]. Decided: whole metres, so that it meets metre lines. */
  static final double TILE = 2;

  /** The same [pixels]. Decided: sharp from a metre away. */
  static final int SIZE = 512;

  /** Edge of a pixel [m]. */
  static final double PIXEL = TILE / SIZE;

  private final int size;
  private final Supplier<Look> look;
  private final Texture texture;

  Wallpaper(int size, Supplier<Look> look) {
    this.size = size;
    this.look = look;
    this.texture = prepared().texture(look);
  }

  /** Always the same; read when it is first looked at. */
  Texture texture() {
    return texture;
  }

  /** The same pixels as those of {@link #texture}, but painted. */
  Texture painted() {
    return Tile.painted(size, look);
  }

  /** The resource. */
  PreparedTile prepared() {
    return new PreparedTile(Wallpaper.class, name().toLowerCase(Locale.ROOT), size);
  }
}
