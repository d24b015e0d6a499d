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
 * The procedural textures of painted obstacles. Each tiles a square of {@link #TILE}, and its paint
 * is uneven. For any thread.
 *
 * @param size edge of the texture, a power of two, at most {@link #LARGEST} [texels]
 */
record PatternTexture(int size) {

  /** Edge of the square that repeats [m]. Decided: whole bricks and squares. */
  static final double TILE = 1;

  /** Decided: as sharp as a wall from half a metre. */
  private static final int LARGEST = 512;

  /** Most textures of the largest size. Decided: they take 60 MB in a window. */
  private static final int MOST_LARGEST = 16;

  /** Most textures of half that size. Decided: they take as much. */
  private static final int MOST_HALF = 64;

  /** From here on a colour is light, 0 to 1. Decided: by eye. */
  private static final double LIGHT = 0.62;

  /** Edge of a square of the checks [m]. */
  private static final double SQUARE = 0.1;

  /** Two stripes, one of each colour, along an edge [m]. Decided: by eye. */
  private static final double STRIPES = 0.25;

  /** Length of a brick with its joint [m]. Documented: DIN 105, normal format, 25 cm by 8⅓ cm. */
  private static final double BRICK = 0.25;

  private static final int COURSES = 12;

  /** Half the thickness of a joint [m]. Assumed: joints of 12 mm. */
  private static final double HALF_JOINT = 0.006;

  /** How far the edge of a brick is uneven [m]. Decided: by eye. */
  private static final double UNEVEN = 0.0025;

  private static final ColorRamp MORTAR = new ColorRamp(Rgb.of(0xa79f94), Rgb.of(0xe6e0d6));

  /** What is the same for all textures; computed for the first one. */
  private static final class Shared {

    static final ValueNoise PAINT =
        new ValueNoise(LARGEST)
            .addOctave(new Lattice(8, 8), 0.3, 53)
            .addOctave(new Lattice(32, 32), 0.3, 54)
            .addOctave(new Lattice(128, 128), 0.4, 55);
  }

  /** The size for so many different textures: the more there are, the smaller each is. */
  static PatternTexture forCount(long textures) {
    if (textures <= MOST_LARGEST) {
      return new PatternTexture(LARGEST);
    }
    return new PatternTexture(textures <= MOST_HALF ? LARGEST / 2 : LARGEST / 8);
  }

  /** After how many metres a pattern repeats. */
  static double period(Pattern pattern) {
    return switch (pattern) {
      case PLAIN -> TILE;
      case CHECKS -> 2 * SQUARE;
      case STRIPES -> STRIPES;
      case BRICKS -> BRICK;
    };
  }

  /**
   * A texture of this pattern and colour, painted when it is first used.
   *
   * @param material of what has no pattern
   */
  Texture of(Pattern pattern, Rgb color, ObstacleMaterial material) {
    return switch (pattern) {
      case PLAIN -> ProceduralTexture.of(size, () -> material.texels(size, color));
      case CHECKS -> ProceduralTexture.of(size, () -> checks(color));
      case STRIPES -> ProceduralTexture.of(size, () -> stripes(color));
      case BRICKS -> ProceduralTexture.of(size, () -> bricks(color));
    };
  }

  /** Squares in two colours, no two quite alike. */
  private ProceduralTexture.Texels checks(Rgb color) {
    int squares = (int) Math.round(TILE / SQUARE);
    ColorRamp own = ramp(color, 0.25);
    ColorRamp other = ramp(contrasting(color), 0.25);
    ToneTable tones = new ToneTable(squares * squares, 59);
    return (x, y) -> {
      double across = (x + 0.5) * squares / size;
      double down = (y + 0.5) * squares / size;
      // positive inside a square of its own colour, negative in one of the other
      double inside = alternating(across / 2) * alternating(down / 2) < 0 ? -1 : 1;
      double edge = Math.min(Math.abs(alternating(across / 2)), Math.abs(alternating(down / 2)));
      double weight = 0.5 + inside * 2 * edge * SQUARE / texel();
      double tone = tones.tone(((int) down) * squares + (int) across);
      double shade = 0.25 + 0.5 * tone + 0.25 * noise(x, y);
      return ProceduralTexture.mix(other.argb(shade), own.argb(shade), weight);
    };
  }

  /** Slanted stripes in two colours, as on barriers. */
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

  /** Bricks in one colour, each course shifted by half a brick. */
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

  /** Edge of a texel [m]. */
  private double texel() {
    return TILE / size;
  }

  /** How far paint is off its mean at a texel, -1 to 1. */
  private double noise(int x, int y) {
    int step = LARGEST / size;
    return Shared.PAINT.at(x * step, y * step);
  }

  /** Distance to the nearest half in periods; positive in the first half of each, else negative. */
  private static double alternating(double periods) {
    double phase = periods - Math.floor(periods);
    return phase < 0.5 ? Math.min(phase, 0.5 - phase) : -Math.min(phase - 0.5, 1 - phase);
  }

  static double fromWhole(double number) {
    double part = number - (int) number;
    return Math.min(part, 1 - part);
  }

  /** A colour that stands out against another one: white, or for a light one dark. */
  private static Rgb contrasting(Rgb color) {
    return color.luma() < LIGHT ? Rgb.of(0xf6f4ee) : color.shaded(0.35);
  }

  /**
   * Shades around a colour: 0.5 is the colour.
   *
   * @param spread how far they go, 0 to 1
   */
  private static ColorRamp ramp(Rgb color, double spread) {
    return new ColorRamp(color.shaded(1 - spread), color.towards(Rgb.WHITE, spread));
  }
}
