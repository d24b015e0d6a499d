package tellosimulator.scenery.furniture;

import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.texture.ColorRamp;
import tellosimulator.scenery.texture.ProceduralTexture;
import tellosimulator.scenery.texture.ProceduralTexture.Texels;
import tellosimulator.scenery.texture.ValueNoise;
import tellosimulator.scenery.texture.ValueNoise.Lattice;
import tellosimulator.world.Shape;

/**
 * The material of an obstacle without a pattern, in the obstacle's colour. A scenario specifies
 * only shape and colour; the material is derived from them. Decided: all values, by eye.
 */
enum ObstacleMaterial {
  /** A painted wall, board or column. */
  PAINT {
    @Override
    Texels texels(int size, Rgb color) {
      ColorRamp ramp = ramp(color, 0.05);
      return (x, y) -> ramp.argb(0.5 + 0.5 * at(Noise.EVEN, x, y, size));
    }
  },

  /** Boards with a horizontal grain. */
  WOOD {
    @Override
    Texels texels(int size, Rgb color) {
      ColorRamp ramp = ramp(color, 0.3);
      int joint = color.shaded(0.55).argb();
      return (x, y) -> {
        double boards = (y + 0.5) * BOARDS / size;
        double fromJoint = PatternTexture.fromWhole(boards) / BOARDS / JOINT;
        double tone = 0.44 + 0.12 * ((int) boards % 2) + 0.5 * at(Noise.ACROSS, x, y, size);
        return ProceduralTexture.mix(joint, ramp.argb(tone), fromJoint);
      };
    }
  },

  /** Brushed metal. */
  METAL {
    @Override
    Texels texels(int size, Rgb color) {
      ColorRamp ramp = ramp(color, 0.13);
      return (x, y) -> ramp.argb(0.5 + 0.5 * at(Noise.UPRIGHT, x, y, size));
    }
  },

  /** Cloth whose threads are visible from close up. */
  FABRIC {
    @Override
    Texels texels(int size, Rgb color) {
      ColorRamp ramp = ramp(color, 0.16);
      return (x, y) -> {
        double across = StrictMath.sin(2 * Math.PI * THREADS * x / size);
        double along = StrictMath.sin(2 * Math.PI * THREADS * y / size);
        return ramp.argb(0.5 + 0.2 * across * along + 0.35 * at(Noise.EVEN, x, y, size));
      };
    }
  },

  /** Segments in two shades of a gate's colour, so that programs can detect the gate. */
  SEGMENTS {
    @Override
    Texels texels(int size, Rgb color) {
      ColorRamp own = ramp(color, 0.06);
      ColorRamp other = ramp(color.shaded(DARKER), 0.06);
      return (x, y) -> {
        double segments = (x + 0.5) / size * PatternTexture.TILE / SEGMENT;
        double within = segments - (int) segments;
        double inside = Math.min(within, OWN_PART - within) * SEGMENT * size;
        double shade = 0.5 + 0.5 * at(Noise.EVEN, x, y, size);
        return ProceduralTexture.mix(other.argb(shade), own.argb(shade), 0.5 + inside);
      };
    }
  };

  /**
   * Brightness of the darker segments, relative to the lighter ones. Decided: the difference is
   * visible, but both still look like the same colour.
   */
  private static final double DARKER = 0.82;

  /** Length of a pair of segments, one in each shade [m]. */
  static final double SEGMENT = 0.5;

  /** Length of the lighter segment, which has the gate's own colour, as a fraction of the pair. */
  private static final double OWN_PART = 0.6;

  private static final int BOARDS = 8;

  /** Half the width of a joint between boards [m]. */
  private static final double JOINT = 0.003;

  /** Number of threads per metre; there are as many gaps. */
  private static final int THREADS = 128;

  /** A round obstacle up to this radius is made of metal [m]. */
  private static final double POLE = 0.12;

  /** An obstacle up to this thickness that is taller than it is thick is a wall [m]. */
  private static final double WALL = 0.3;

  /** An obstacle up to this height that is not made of wood is upholstered [m]. */
  private static final double SEAT = 0.65;

  private static final int NOISE_SIZE = 512;

  /** The noise that all colours share; computed on first use. */
  private static final class Noise {

    static final ValueNoise EVEN = noise(new Lattice(16, 16), new Lattice(128, 128));
    static final ValueNoise ACROSS = noise(new Lattice(4, 64), new Lattice(16, 256));
    static final ValueNoise UPRIGHT = noise(new Lattice(64, 2), new Lattice(256, 4));

    private static ValueNoise noise(Lattice coarse, Lattice fine) {
      return new ValueNoise(NOISE_SIZE).addOctave(coarse, 0.5, 81).addOctave(fine, 0.5, 82);
    }
  }

  /** Returns the material of an obstacle without a pattern. */
  static ObstacleMaterial of(Shape shape, Rgb color) {
    if (shape instanceof Shape.Gate) {
      return SEGMENTS;
    }
    double thinnest = Math.min(shape.size().x(), shape.size().y());
    if (shape.round()) {
      return thinnest <= 2 * POLE ? METAL : shape.height() <= SEAT ? FABRIC : PAINT;
    }
    if (thinnest <= WALL && shape.height() > thinnest) {
      return PAINT;
    }
    return woody(color) ? WOOD : shape.height() <= SEAT ? FABRIC : PAINT;
  }

  /** Returns whether a colour is brown, or otherwise between yellow and red but not too bright. */
  private static boolean woody(Rgb color) {
    int red = color.red();
    int green = color.green();
    int blue = color.blue();
    return red > green && green > blue && red - blue > 40 && green * 10 > 4 * red && red < 235;
  }

  /**
   * Returns shades of a colour, with the colour itself in the middle.
   *
   * @param spread relative change in brightness at either end of the ramp, 0 to 1
   */
  private static ColorRamp ramp(Rgb color, double spread) {
    Rgb light =
        new Rgb(
            brighter(color.red(), spread),
            brighter(color.green(), spread),
            brighter(color.blue(), spread));
    return new ColorRamp(color.shaded(1 - spread), light);
  }

  private static int brighter(int channel, double spread) {
    return (int) Math.min(255, Math.round(channel * (1 + spread)));
  }

  private static double at(ValueNoise noise, int x, int y, int size) {
    int step = NOISE_SIZE / size;
    return noise.at(x * step, y * step);
  }

  /**
   * Returns the texels of this material in a given colour.
   *
   * @param size side length of the texture [texels]; the texture covers {@link PatternTexture#TILE}
   */
  abstract Texels texels(int size, Rgb color);
}
