package tellosimulator.scenery.furniture;

import tellosimulator.scenery.Rgb;
import tellosimulator.scenery.paint.Shades;
import tellosimulator.scenery.paint.Tile;
import tellosimulator.scenery.paint.Tones;

/** Squares of 10 cm in two colours, no two quite alike. */
final class Checks {

  /** Two squares [m]. */
  static final double PERIOD = 0.2;

  private static final long SEED = 59;

  private static final int SQUARES = (int) Math.round(2 * Coat.TILE / PERIOD);

  private final Shades own;
  private final Shades other;
  private final Grit grit;
  private final Tones tones = new Tones(SQUARES * SQUARES, SEED);

  Checks(Rgb color, Grit grit) {
    this.grit = grit;
    own = Grit.around(color, 0.25);
    other = Grit.around(Grit.against(color), 0.25);
  }

  int argb(int x, int y) {
    double across = (x + 0.5) * SQUARES / grit.pixels();
    double down = (y + 0.5) * SQUARES / grit.pixels();
    // how far inside a square of its own colour: negative in one of the other
    double inside = signed(across) * signed(down) < 0 ? -1 : 1;
    double edge = Math.min(Math.abs(signed(across)), Math.abs(signed(down)));
    double part = 0.5 + inside * edge * (PERIOD / 2) / grit.pixel();
    double tone = tones.of(((int) down) * SQUARES + (int) across);
    double shade = 0.25 + 0.5 * tone + 0.25 * grit.at(x, y);
    return Tile.mixed(other.argb(shade), own.argb(shade), part);
  }

  /** Distance to the nearest edge in squares; below 0 in every other square. */
  private static double signed(double place) {
    double inPair = place / 2 - Math.floor(place / 2);
    return inPair < 0.5
        ? Math.min(2 * inPair, 1 - 2 * inPair)
        : -Math.min(2 * inPair - 1, 2 - 2 * inPair);
  }
}
