package tellosimulator.scenery.furniture;

import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.texture.ColorRamp;
import tellosimulator.scenery.texture.ProceduralTexture;
import tellosimulator.scenery.texture.ToneTable;
import tellosimulator.scenery.texture.ValueNoise;
import tellosimulator.scenery.texture.ValueNoise.Lattice;
import tellosimulator.world.ObstacleAppearance.Pattern;

/**
 * The procedural textures of painted obstacles. Each texture tiles without a seam, covers a square
 * with sides of {@link #TILE}, and shows slightly uneven paint. Immutable.
 *
 * @param size side length of a texture, a power of two, at most {@link #LARGEST} [texels]
 */
record PatternTexture(int size) {

  /** Side length of the repeating square [m]. Decided: a whole number of bricks and of squares. */
  static final double TILE = 1;

  /** Maximum side length of a texture [texels]. Decided: sharp from half a metre away. */
  private static final int LARGEST = 512;

  /**
   * Maximum number of textures that may have the largest size. Decided: together they take 60 MB
   * while a window is open.
   */
  private static final int MOST_LARGEST = 16;

  /**
   * Maximum number of textures that may have half of the largest size. Decided: together they take
   * as much memory as {@link #MOST_LARGEST} textures of the largest size.
   */
  private static final int MOST_HALF = 64;

  /** Minimum luma of a colour that counts as light, 0 to 1. Decided: by eye. */
  private static final double LIGHT = 0.62;

  /** Side length of a square in the checks [m]. */
  private static final double SQUARE = 0.1;

  /**
   * Width of a pair of stripes, one in each colour, measured along an edge [m]. Decided: by eye.
   */
  private static final double STRIPES = 0.25;

  /** Length of a brick and its joint [m]. Documented: DIN 105, normal format, 25 cm by 8⅓ cm. */
  private static final double BRICK = 0.25;

  private static final int COURSES = 12;

  /** Half the thickness of a joint [m]. Assumed: joints of 12 mm. */
  private static final double HALF_JOINT = 0.006;

  /** Unevenness of the edges of bricks [m]. Decided: by eye. */
  private static final double UNEVEN = 0.0025;

  private static final ColorRamp MORTAR = new ColorRamp(Rgb.of(0xa79f94), Rgb.of(0xe6e0d6));

  /** The noise that all textures share; computed on first use. */
  private static final class Shared {

    static final ValueNoise PAINT =
        new ValueNoise(LARGEST)
            .addOctave(new Lattice(8, 8), 0.3, 53)
            .addOctave(new Lattice(32, 32), 0.3, 54)
            .addOctave(new Lattice(128, 128), 0.4, 55);
  }

  /**
   * Returns textures for a given number of different paints: the more there are, the smaller each
   * texture is.
   */
  static PatternTexture forCount(long textures) {
    if (textures <= MOST_LARGEST) {
      return new PatternTexture(LARGEST);
    }
    return new PatternTexture(textures <= MOST_HALF ? LARGEST / 2 : LARGEST / 8);
  }

  /** Returns the period of a pattern [m]. */
  static double period(Pattern pattern) {
    return switch (pattern) {
      case PLAIN -> TILE;
      case CHECKS -> 2 * SQUARE;
      case STRIPES -> STRIPES;
      case BRICKS -> BRICK;
    };
  }

  /**
   * Returns a texture of this pattern and colour. The texture is painted on first use.
   *
   * @param material only used if there is no pattern
   */
  Texture of(Pattern pattern, Rgb color, ObstacleMaterial material) {
    return switch (pattern) {
      case PLAIN -> ProceduralTexture.of(size, () -> material.texels(size, color));
      case CHECKS -> ProceduralTexture.of(size, () -> checks(color));
      case STRIPES -> ProceduralTexture.of(size, () -> stripes(color));
      case BRICKS -> ProceduralTexture.of(size, () -> bricks(color));
    };
  }

  /** Paints squares in two colours, each in a slightly different tone. */
  private ProceduralTexture.Texels checks(Rgb color) {
    int squares = (int) Math.round(TILE / SQUARE);
    ColorRamp own = ramp(color, 0.25);
    ColorRamp other = ramp(contrasting(color), 0.25);
    ToneTable tones = new ToneTable(squares * squares, 59);
    return (x, y) -> {
      double across = (x + 0.5) * squares / size;
      double down = (y + 0.5) * squares / size;
      // positive in a square of this colour, negative in a square of the contrasting colour
      double inside = alternating(across / 2) * alternating(down / 2) < 0 ? -1 : 1;
      double edge = Math.min(Math.abs(alternating(across / 2)), Math.abs(alternating(down / 2)));
      double weight = 0.5 + inside * 2 * edge * SQUARE / texel();
      double tone = tones.tone(((int) down) * squares + (int) across);
      double shade = 0.25 + 0.5 * tone + 0.25 * noise(x, y);
      return ProceduralTexture.mix(other.argb(shade), own.argb(shade), weight);
    };
  }

  /** Paints diagonal stripes in two colours, as on barriers. */
  private ProceduralTexture.Texels stripes(Rgb color) {
    ColorRamp own = ramp(color, 0.2);
    ColorRamp other = ramp(contrasting(color), 0.2);
    return (x, y) -> {
      double along = (x + y + 1) * (TILE / STRIPES) / size;
      double weight = 0.5 + alternating(along) * STRIPES * Math.sqrt(0.5) / texel();
      double shade = 0.5 + 0.45 * noise(x, y);
      return ProceduralTexture.mix(other.argb(shade), own.argb(shade), weight);
    };
  }

  /** Paints bricks in one colour, each course shifted by half a brick. */
  private ProceduralTexture.Texels bricks(Rgb color) {
    int bricks = (int) Math.round(TILE / BRICK);
    ColorRamp stone = ramp(color, 0.4);
    ToneTable tones = new ToneTable(COURSES * bricks, 61);
    return (x, y) -> {
      double down = (y + 0.5) * COURSES / size;
      int course = (int) down;
      double across = (x + 0.5) * bricks / size + 0.5 * (course % 2);
      int brick = (int) across;
      double uneven = noise(x, y);
      double fromEdge = Math.min(TILE / COURSES * fromWhole(down), BRICK * fromWhole(across));
      double tone = 0.15 + 0.7 * tones.tone(course * bricks + brick % bricks) + 0.3 * uneven;
      double weight = (fromEdge - HALF_JOINT + UNEVEN * uneven) / texel() + 0.5;
      return ProceduralTexture.mix(MORTAR.argb(0.5 + 0.5 * uneven), stone.argb(tone), weight);
    };
  }

  /** Returns the side length of a texel [m]. */
  private double texel() {
    return TILE / size;
  }

  /** Returns the deviation of the paint's tone at a texel from the mean tone, -1 to 1. */
  private double noise(int x, int y) {
    int step = LARGEST / size;
    return Shared.PAINT.at(x * step, y * step);
  }

  /**
   * Returns the distance to the nearest half period: positive in the first half of each period,
   * negative in the second.
   */
  private static double alternating(double periods) {
    double phase = periods - Math.floor(periods);
    return phase < 0.5 ? Math.min(phase, 0.5 - phase) : -Math.min(phase - 0.5, 1 - phase);
  }

  static double fromWhole(double number) {
    double part = number - (int) number;
    return Math.min(part, 1 - part);
  }

  /** Returns a contrasting colour: a dark shade for a light colour, otherwise white. */
  private static Rgb contrasting(Rgb color) {
    return color.luma() < LIGHT ? Rgb.of(0xf6f4ee) : color.shaded(0.35);
  }

  /**
   * Returns shades of a colour, with the colour itself at 0.5.
   *
   * @param spread weight of black and of white at the ends of the ramp, 0 to 1
   */
  private static ColorRamp ramp(Rgb color, double spread) {
    return new ColorRamp(color.shaded(1 - spread), color.towards(Rgb.WHITE, spread));
  }
}
