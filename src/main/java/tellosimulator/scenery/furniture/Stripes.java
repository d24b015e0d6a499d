package tellosimulator.scenery.furniture;

import tellosimulator.scenery.Rgb;
import tellosimulator.scenery.paint.Shades;
import tellosimulator.scenery.paint.Tile;

/** Slanted stripes in two colours, as on barriers. */
final class Stripes {

  /** A stripe of each colour, along the edge of a thing [m]. Decided: by eye. */
  static final double PERIOD = 0.25;

  private static final double PERIODS = Coat.TILE / PERIOD;

  private final Shades own;
  private final Shades other;
  private final Grit grit;

  Stripes(Rgb color, Grit grit) {
    this.grit = grit;
    own = Grit.around(color, 0.2);
    other = Grit.around(Grit.against(color), 0.2);
  }

  int argb(int x, int y) {
    double along = (x + y + 1) * PERIODS / grit.pixels();
    double inPair = along - Math.floor(along);
    double fromEdge =
        inPair < 0.5 ? Math.min(inPair, 0.5 - inPair) : -Math.min(inPair - 0.5, 1 - inPair);
    double pixels = fromEdge * PERIOD * Math.sqrt(0.5) / grit.pixel();
    double shade = 0.5 + 0.45 * grit.at(x, y);
    return Tile.mixed(other.argb(shade), own.argb(shade), 0.5 + pixels);
  }
}
