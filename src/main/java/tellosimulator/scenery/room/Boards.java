package tellosimulator.scenery.room;

import tellosimulator.scenery.Rgb;
import tellosimulator.scenery.paint.Field;
import tellosimulator.scenery.paint.Field.Grain;
import tellosimulator.scenery.paint.Shades;
import tellosimulator.scenery.paint.Tile;
import tellosimulator.scenery.paint.Tile.Look;
import tellosimulator.scenery.paint.Tones;

/** Upright boards, painted green and worn, of three widths and with butts here and there. */
final class Boards {

  private static final long SEED = 23;

  /** Right edges of the boards, in parts of the tile. Decided: by eye. */
  private static final double[] EDGES = {
    0.055, 0.125, 0.17, 0.24, 0.285, 0.345, 0.415, 0.46, 0.53, 0.575, 0.63, 0.705, 0.75, 0.82,
    0.875, 0.925, 1
  };

  /** How much higher a board's butts are than those of the one before, in parts of the tile. */
  private static final double BUTT = 0.37;

  /** Half the width of a gap [m]. Decided: by eye. */
  private static final double HALF_GAP = 0.0035;

  private static final Shades WOOD = new Shades(Rgb.of(0x456a4f), Rgb.of(0xe2edd8));
  private static final int GAP = Rgb.of(0x38493b).argb();

  private final Tones tones = new Tones(2 * EDGES.length, SEED);
  private final Field grain =
      new Field(Wallpaper.SIZE)
          .rough(new Grain(16, 2), 0.35, SEED)
          .rough(new Grain(64, 8), 0.4, SEED + 1)
          .rough(new Grain(256, 16), 0.25, SEED + 2);

  private Boards() {}

  static Look look() {
    return new Boards()::argb;
  }

  private int argb(int x, int y) {
    double across = (x + 0.5) / Wallpaper.SIZE;
    double down = (y + 0.5) / Wallpaper.SIZE;
    int board = 0;
    while (across > EDGES[board]) {
      board++;
    }
    double left = board == 0 ? 0 : EDGES[board - 1];
    double pieces = 2 * (down + board * BUTT);
    double fromButt = Math.abs(pieces - Math.rint(pieces)) / 2;
    double fromEdge = Math.min(Math.min(across - left, EDGES[board] - across), fromButt);
    double tone = tones.of(2 * board + (int) Math.floor(pieces) % 2);
    double wood = (fromEdge * Wallpaper.TILE - HALF_GAP) / Wallpaper.PIXEL + 0.5;
    int worn = WOOD.argb(0.08 + 0.84 * tone + 0.3 * grain.at(x + 37 * board, y + 91 * board));
    return Tile.mixed(GAP, worn, wood);
  }
}
