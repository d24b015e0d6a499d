package tellosimulator.scenery.room;

import tellosimulator.scenery.Rgb;
import tellosimulator.scenery.paint.Field;
import tellosimulator.scenery.paint.Field.Grain;
import tellosimulator.scenery.paint.Shades;
import tellosimulator.scenery.paint.Tile;
import tellosimulator.scenery.paint.Tile.Look;
import tellosimulator.scenery.paint.Tones;

/** Light square panels with dark joints. */
final class CeilingPanels {

  private static final long SEED = 97;

  static final int SIZE = 256;

  private static final int PANELS = 4;

  private static final Shades PANEL = new Shades(Rgb.of(0xcfccc6), Rgb.of(0xf4f2ee));
  private static final int JOINT = Rgb.of(0x8d8a85).argb();

  private final Tones tones = new Tones(PANELS * PANELS, SEED);
  private final Field uneven =
      new Field(SIZE).rough(new Grain(16, 16), 0.5, SEED).rough(new Grain(64, 64), 0.5, SEED + 1);

  private CeilingPanels() {}

  static Look look() {
    return new CeilingPanels()::argb;
  }

  private int argb(int x, int y) {
    double across = (x + 0.5) * PANELS / SIZE;
    double down = (y + 0.5) * PANELS / SIZE;
    double fromEdge = Math.min(fromWhole(across), fromWhole(down)) * SIZE / PANELS;
    int panel = (int) Math.floor(down) * PANELS + (int) Math.floor(across);
    double tone = tones.of(panel);
    return Tile.mixed(JOINT, PANEL.argb(0.2 + 0.6 * tone + 0.2 * uneven.at(x, y)), fromEdge - 0.5);
  }

  private static double fromWhole(double number) {
    return Math.abs(number - Math.rint(number));
  }
}
