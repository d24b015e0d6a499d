package tellosimulator.scenery.room;

import tellosimulator.scenery.Rgb;
import tellosimulator.scenery.paint.Field;
import tellosimulator.scenery.paint.Field.Grain;
import tellosimulator.scenery.paint.Shades;
import tellosimulator.scenery.paint.Tile;
import tellosimulator.scenery.paint.Tile.Look;
import tellosimulator.scenery.paint.Tones;

/** Ochre wallpaper with triangles of a hand's size, printed a little unevenly. */
final class Triangles {

  private static final long SEED = 37;

  /** Rows and columns of squares, each of two triangles with a slanted edge between them. */
  private static final int CELLS = 10;

  /** Half the width of the line between triangles [m]. Decided: by eye. */
  private static final double HALF_LINE = 0.004;

  private static final double CELL = Wallpaper.TILE / CELLS;

  private static final Shades PRINT = new Shades(Rgb.of(0x9a6918), Rgb.of(0xf8ebc6));
  private static final int LINE = Rgb.of(0xfbf4e2).argb();

  private final Tones tones = new Tones(2 * CELLS * CELLS, SEED);
  private final Field uneven =
      new Field(Wallpaper.SIZE)
          .rough(new Grain(8, 8), 0.3, SEED)
          .rough(new Grain(32, 32), 0.3, SEED + 1)
          .rough(new Grain(128, 128), 0.4, SEED + 2);

  private Triangles() {}

  static Look look() {
    return new Triangles()::argb;
  }

  private int argb(int x, int y) {
    double across = (x + 0.5) * CELLS / Wallpaper.SIZE;
    double down = (y + 0.5) * CELLS / Wallpaper.SIZE;
    int column = (int) across;
    int row = (int) down;
    double right = across - column;
    double below = down - row;
    double along = (row + column) % 2 == 0 ? right : 1 - right;
    double fromSlant = Math.abs(along - below) * Math.sqrt(0.5);
    double fromSide = Math.min(Math.min(right, 1 - right), Math.min(below, 1 - below));
    int triangle = 2 * (row * CELLS + column) + (along > below ? 1 : 0);
    double tone = 0.1 + 0.8 * tones.of(triangle) + 0.25 * uneven.at(x, y);
    double print = (Math.min(fromSide, fromSlant) * CELL - HALF_LINE) / Wallpaper.PIXEL + 0.5;
    return Tile.mixed(LINE, PRINT.argb(tone), print);
  }
}
