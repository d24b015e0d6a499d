package tellosimulator.scenery.room;

import tellosimulator.scenery.Rgb;
import tellosimulator.scenery.paint.Field;
import tellosimulator.scenery.paint.Field.Grain;
import tellosimulator.scenery.paint.Shades;
import tellosimulator.scenery.paint.Tile;
import tellosimulator.scenery.paint.Tile.Look;
import tellosimulator.scenery.paint.Tones;

/** Blue six-sided tiles with light joints. */
final class Hexagons {

  private static final long SEED = 53;

  private static final int COLUMNS = 12;

  /** Even, so that it repeats; tiles are a hundredth higher than regular ones. */
  private static final int ROWS = 14;

  /** From row to row, in widths of a tile. */
  private static final double ROW_HEIGHT = Math.sqrt(0.75);

  /** Half the width of a joint [m]. Decided: by eye. */
  private static final double HALF_JOINT = 0.004;

  private static final double WIDTH = Wallpaper.TILE / COLUMNS;

  private static final Shades GLAZE = new Shades(Rgb.of(0x33618f), Rgb.of(0xd2e7f5));
  private static final int JOINT = Rgb.of(0xf0f2f1).argb();

  private final Tones tones = new Tones(COLUMNS * ROWS, SEED);
  private final Field uneven =
      new Field(Wallpaper.SIZE)
          .rough(new Grain(4, 4), 0.25, SEED)
          .rough(new Grain(32, 32), 0.4, SEED + 1)
          .rough(new Grain(128, 128), 0.35, SEED + 2);

  private Hexagons() {}

  static Look look() {
    return new Hexagons()::argb;
  }

  /** A pixel is part of the tile whose middle is nearest, in one of the two nearest rows. */
  private int argb(int x, int y) {
    double across = (x + 0.5) * COLUMNS / Wallpaper.SIZE;
    double down = (y + 0.5) * ROWS / Wallpaper.SIZE;
    int above = (int) Math.floor(down - 0.5);
    double toEdge = toEdge(across, down, above);
    double toEdgeBelow = toEdge(across, down, above + 1);
    int row = toEdge > toEdgeBelow ? above : above + 1;
    int column = Math.floorMod((int) Math.floor(across - shift(row)), COLUMNS);
    double glaze = (Math.max(toEdge, toEdgeBelow) * WIDTH - HALF_JOINT) / Wallpaper.PIXEL + 0.5;
    double tone = tones.of(Math.floorMod(row, ROWS) * COLUMNS + column);
    return Tile.mixed(JOINT, GLAZE.argb(0.1 + 0.8 * tone + 0.25 * uneven.at(x, y)), glaze);
  }

  /**
   * How far a place is within the nearest tile of a row, in widths of a tile.
   *
   * @param across in columns
   * @param down in rows
   */
  private static double toEdge(double across, double down, int row) {
    double inRow = across - shift(row);
    double fromMiddle = Math.abs(inRow - Math.floor(inRow) - 0.5);
    double height = Math.abs(down - row - 0.5) * ROW_HEIGHT;
    return 0.5 - Math.max(fromMiddle, fromMiddle / 2 + height * ROW_HEIGHT);
  }

  private static double shift(int row) {
    return row % 2 == 0 ? 0 : 0.5;
  }
}
