package tellosimulator.scenery.room;

import tellosimulator.scenery.Rgb;
import tellosimulator.scenery.Texture;
import tellosimulator.scenery.paint.Field;
import tellosimulator.scenery.paint.Field.Grain;
import tellosimulator.scenery.paint.Shades;
import tellosimulator.scenery.paint.Tile;
import tellosimulator.scenery.paint.Tile.Look;
import tellosimulator.scenery.paint.Tones;

/**
 * A wooden floor with the lines of the grid on it. Its tile holds whole cells of the grid, so it is
 * as wide as a {@link Wallpaper#TILE} only about; what is in it becomes wider or narrower with it.
 */
final class Parquet {

  private static final long SEED = 71;

  /** Edge of the tile [pixels]. Decided: made quickly, as the first picture waits for it. */
  static final int SIZE = 512;

  /** Strips side by side, each with its pieces one after the other. */
  private static final int STRIPS = 16;

  private static final int PIECES = 3;

  /** Half the width of a gap [pixels]. Decided: by eye. */
  private static final double HALF_GAP = 0.8;

  private static final Shades OAK = new Shades(Rgb.of(0x6f4c2e), Rgb.of(0xe6c9a0));
  private static final int GAP = Rgb.of(0x4a3626).argb();
  private static final int LINE = Rgb.of(0x33302c).argb();

  /** How far the wood shines through a line. Decided: by eye. */
  private static final double LINE_OPACITY = 0.6;

  private final Tones tones = new Tones(STRIPS * PIECES, SEED);
  private final Field grain =
      new Field(SIZE)
          .rough(new Grain(16, 2), 0.3, SEED)
          .rough(new Grain(64, 8), 0.4, SEED + 1)
          .rough(new Grain(256, 16), 0.3, SEED + 2);

  private Parquet() {}

  /** The wood without lines. */
  static Look look() {
    return new Parquet()::wood;
  }

  /** How many cells of a grid are in a tile, in a row and in a column. */
  static int cells(double grid) {
    return (int) Math.max(1, Math.round(Wallpaper.TILE / grid));
  }

  /**
   * A tile. The middle of its first cell is where lines cross.
   *
   * @param grid distance from line to line [m]
   */
  static Texture texture(double grid) {
    return Tile.painted(SIZE, () -> lined(grid));
  }

  private static Look lined(double grid) {
    double cell = (double) SIZE / cells(grid);
    double halfLine = Math.max(1.5, (0.0035 / grid + 0.0075) * cell);
    Texture wood = Wallpaper.PARQUET.texture();
    return (x, y) -> {
      double line = halfLine - Math.min(fromLine(x, cell), fromLine(y, cell)) + 0.5;
      double opacity = LINE_OPACITY * Math.max(0, Math.min(1, line));
      return Tile.mixed(wood.argb(x, y), LINE, opacity);
    };
  }

  private static double fromLine(int pixel, double cell) {
    double cells = (pixel + 0.5) / cell;
    return Math.abs(cells - (int) cells - 0.5) * cell;
  }

  private int wood(int x, int y) {
    double across = (x + 0.5) * STRIPS / SIZE;
    int strip = (int) across;
    double along = (y + 0.5) * PIECES / SIZE + strip * 0.381;
    int piece = strip * PIECES + (int) along % PIECES;
    double fromSide = fromWhole(across) * SIZE / STRIPS;
    double fromEnd = fromWhole(along) * SIZE / PIECES;
    double worn = grain.at(x + 53 * piece, y + 117 * piece);
    int oak = OAK.argb(0.12 + 0.76 * tones.of(piece) + 0.3 * worn);
    return Tile.mixed(GAP, oak, Math.min(fromSide, fromEnd) - HALF_GAP + 0.5);
  }

  private static double fromWhole(double number) {
    return Math.abs(number - (int) (number + 0.5));
  }
}
