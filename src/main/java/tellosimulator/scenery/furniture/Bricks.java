package tellosimulator.scenery.furniture;

import tellosimulator.scenery.Rgb;
import tellosimulator.scenery.paint.Shades;
import tellosimulator.scenery.paint.Tile;
import tellosimulator.scenery.paint.Tones;

/**
 * Bricks in one colour, each course shifted by half a brick. Documented: a brick with its joint is
 * 25 cm long and 8⅓ cm high (DIN 105, normal format).
 */
final class Bricks {

  /** A brick with its joint [m]. */
  static final double PERIOD = 0.25;

  private static final long SEED = 61;

  private static final int COURSES = 12;
  private static final int BRICKS = (int) Math.round(Coat.TILE / PERIOD);
  private static final double COURSE = Coat.TILE / COURSES;

  /** Half the thickness of a joint [m]. Assumed: joints of 12 mm. */
  private static final double HALF_JOINT = 0.006;

  /** How far the edge of a brick is uneven [m]. Decided: by eye. */
  private static final double UNEVEN = 0.0025;

  private static final Shades MORTAR = new Shades(Rgb.of(0xa79f94), Rgb.of(0xe6e0d6));

  private final Shades stone;
  private final Grit grit;
  private final Tones tones = new Tones(COURSES * BRICKS, SEED);

  Bricks(Rgb color, Grit grit) {
    this.grit = grit;
    stone = Grit.around(color, 0.4);
  }

  int argb(int x, int y) {
    double down = (y + 0.5) * COURSES / grit.pixels();
    int course = (int) down;
    double across = (x + 0.5) * BRICKS / grit.pixels() + 0.5 * (course % 2);
    int brick = (int) across;
    double uneven = grit.at(x, y);
    double fromEdge =
        Math.min(COURSE * fromWhole(down - course), PERIOD * fromWhole(across - brick));
    double tone = 0.15 + 0.7 * tones.of(course * BRICKS + brick % BRICKS) + 0.3 * uneven;
    double part = (fromEdge - HALF_JOINT + UNEVEN * uneven) / grit.pixel() + 0.5;
    return Tile.mixed(MORTAR.argb(0.5 + 0.5 * uneven), stone.argb(tone), part);
  }

  private static double fromWhole(double part) {
    return Math.min(part, 1 - part);
  }
}
