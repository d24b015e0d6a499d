package tellosimulator.scenery.room;

import tellosimulator.scenery.Rgb;
import tellosimulator.scenery.paint.Field;
import tellosimulator.scenery.paint.Field.Grain;
import tellosimulator.scenery.paint.Shades;
import tellosimulator.scenery.paint.Tile;
import tellosimulator.scenery.paint.Tile.Look;
import tellosimulator.scenery.paint.Tones;

/**
 * Red bricks, each course shifted by half a brick. Documented: a brick with its joint is 25 cm long
 * and 8⅓ cm high (DIN 105, normal format), so that twelve courses are a metre.
 */
final class Brickwork {

  private static final long SEED = 11;

  private static final int COURSES = 24;
  private static final int BRICKS = 8;

  private static final double COURSE = Wallpaper.TILE / COURSES;
  private static final double BRICK = Wallpaper.TILE / BRICKS;

  /** Half the thickness of a joint [m]. Assumed: joints of 12 mm. */
  private static final double HALF_JOINT = 0.006;

  /** How far the edge of a brick is uneven [m]. Decided: by eye. */
  private static final double UNEVEN = 0.003;

  private static final Shades STONE = new Shades(Rgb.of(0x753624), Rgb.of(0xf3c4a4));
  private static final Shades MORTAR = new Shades(Rgb.of(0xc2b8ab), Rgb.of(0xeae4da));

  private final Tones tones = new Tones(COURSES * BRICKS, SEED);
  private final Field rough =
      new Field(Wallpaper.SIZE)
          .rough(new Grain(4, 4), 0.25, SEED)
          .rough(new Grain(32, 64), 0.4, SEED + 1)
          .rough(new Grain(128, 128), 0.35, SEED + 2);

  private Brickwork() {}

  static Look look() {
    return new Brickwork()::argb;
  }

  private int argb(int x, int y) {
    double down = (double) y * COURSES / Wallpaper.SIZE;
    int course = (int) down;
    double across = (double) x * BRICKS / Wallpaper.SIZE + 0.5 * (course % 2);
    int brick = (int) across;
    double uneven = rough.at(x, y);
    double fromEdge =
        Math.min(COURSE * fromWhole(down - course), BRICK * fromWhole(across - brick));
    double tone = 0.1 + 0.8 * tones.of(course * BRICKS + brick % BRICKS) + 0.25 * uneven;
    double stone = (fromEdge - HALF_JOINT + UNEVEN * uneven) / Wallpaper.PIXEL + 0.5;
    return Tile.mixed(MORTAR.argb(0.5 + 0.5 * uneven), STONE.argb(tone), stone);
  }

  private static double fromWhole(double part) {
    return Math.min(part, 1 - part);
  }
}
