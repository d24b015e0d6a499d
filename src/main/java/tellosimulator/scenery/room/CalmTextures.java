package tellosimulator.scenery.room;

import java.util.EnumMap;
import java.util.Map;
import java.util.OptionalInt;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.texture.ColorRamp;
import tellosimulator.scenery.texture.ProceduralTexture;
import tellosimulator.scenery.texture.ToneTable;
import tellosimulator.scenery.texture.ValueNoise;
import tellosimulator.scenery.texture.ValueNoise.Lattice;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;

/**
 * The textures of calm rooms ({@code Walls.AUTO}): oak on the floor, and roughcast on the walls and
 * the ceiling. The roughcast is a little darker near the floor and away from the windows. The front
 * wall has an accent colour. The pores of the oak and the relief of the roughcast provide features
 * in each picture for programs that process a drone's video; from a few metres away, they are
 * hardly visible. Decided: all values, by eye, and by the number of features.
 */
final class CalmTextures {

  /**
   * Width of the texture of the front wall [texels]. This texture is larger than the others,
   * because drones see the front wall from their start. Decided: about 5 mm a texel in most rooms.
   */
  private static final int FRONT_WIDTH = 1024;

  /**
   * Width of the textures of the ceiling and of all walls except the front wall [texels]. Each
   * texture of plaster is half as high as it is wide. Decided: with a heap of 32 MB, video still
   * works.
   */
  private static final int PLASTER_WIDTH = 512;

  /** Number of samples of the roughcast's relief per metre. */
  private static final int SAMPLES = 200;

  /** Brightness that the relief adds where it faces the light, for each unit of its slope. */
  private static final double RELIEF_LIGHT = 0.1;

  /**
   * Brightness that the relief removes where it faces away from the light, for each unit of its
   * slope.
   */
  private static final double RELIEF_SHADE = 0.26;

  /** Number of boards across a tile; each board is 10 cm wide. */
  private static final int BOARDS = 20;

  /** Number of boards along a tile; each board is 1 m long. */
  private static final int LENGTHS = 2;

  /**
   * Offset of a board from its left neighbour, in board lengths: the fractional part of the golden
   * ratio, so that joints do not line up.
   */
  private static final double SHIFT = 0.618;

  private static final ColorRamp OAK = new ColorRamp(Rgb.of(0xc3ab8b), Rgb.of(0xdbc8ac));

  /** Colour of joints and pores. */
  private static final int JOINT = Rgb.of(0x9c8464).argb();

  /** Noise value above which a texel belongs to a pore. */
  private static final double PORE = 0.55;

  /** Increase in the opacity of a pore for each unit of noise above {@link #PORE}. */
  private static final double PORE_SLOPE = 4;

  private static final double PORE_OPACITY = 0.8;

  /** Visible width of a joint [texels]. */
  private static final double JOINT_WIDTH = 1.3;

  static final Rgb ACCENT = Rgb.of(0xaabfb0);
  private static final Rgb PLASTER = Rgb.of(0xf0ede7);
  private static final Rgb CEILING = Rgb.of(0xf4f2ee);

  /** Half the width of the line at each metre of height [m]. */
  private static final double LINE = 0.006;

  /** Brightness of the line, relative to the plaster around it. */
  private static final double LINE_SHADE = 0.9;

  /** Brightness at the foot of a wall, relative to its top. */
  private static final double LOW = 0.94;

  /** Brightness that is lost for each metre of distance from the wall with the windows. */
  private static final double FALLOFF = 0.012;

  /** Maximum loss of brightness away from the windows. */
  private static final double MOST_FALLOFF = 0.1;

  private CalmTextures() {}

  /** The cache key for the textures of a calm room's walls. */
  record Plaster(Room room, OptionalInt accent) {}

  /**
   * Returns one texture for each wall and one for the ceiling, with ambient occlusion along the
   * edges.
   */
  static Map<Surface, Texture> plastered(Plaster walls) {
    Map<Surface, Texture> textures = new EnumMap<>(Surface.class);
    for (Surface surface : Surface.values()) {
      if (surface != Surface.FLOOR) {
        Rgb color =
            switch (surface) {
              case FRONT_WALL ->
                  walls.accent.isPresent() ? Rgb.of(walls.accent.getAsInt()) : ACCENT;
              case BACK_WALL -> PLASTER.shaded(0.985);
              case LEFT_WALL -> PLASTER.shaded(0.965);
              case CEILING -> CEILING;
              default -> PLASTER;
            };
        Face face = Face.of(walls.room, surface);
        int width = surface == Surface.FRONT_WALL ? FRONT_WIDTH : PLASTER_WIDTH;
        double windows = walls.room.width() / 2;
        textures.put(
            surface, Texture.lazy(width, width / 2, () -> texels(width, color, face, windows)));
      }
    }
    return textures;
  }

  /**
   * Computes a tile of the floor without grid lines. Its boards run towards the front wall; its
   * side has {@link SurfaceTexture#SIZE} texels.
   */
  static ProceduralTexture.Texels oak() {
    int size = SurfaceTexture.SIZE;
    byte[] pores = pores(size);
    ValueNoise grain =
        new ValueNoise(size)
            .addOctave(new Lattice(128, 4), 0.5, 71)
            .addOctave(new Lattice(256, 16), 0.5, 72);
    ToneTable tones = new ToneTable(BOARDS * LENGTHS, 73);
    return (x, y) -> {
      double across = (x + 0.5) * BOARDS / size;
      int board = (int) across;
      double along = (y + 0.5) * LENGTHS / size + SHIFT * board;
      int length = (int) along % LENGTHS;
      double tone = 0.25 + 0.5 * tones.tone(board * LENGTHS + length);
      double fromJoint =
          Math.min(fromWhole(across) * size / BOARDS, fromWhole(along) * size / LENGTHS);
      double pore = (pores[y * size + x] & 255) / 256.0;
      return ProceduralTexture.mix(
          OAK.argb(tone + 0.25 * grain.at(x, y + 61 * board)),
          JOINT,
          Math.max(pore, 1 - fromJoint / JOINT_WIDTH));
    };
  }

  /**
   * Returns the opacity of the pores at each texel, in units of 1/256. Bytes need a quarter of the
   * memory that the noise needs, and the noise can be freed before the grain is computed.
   */
  private static byte[] pores(int size) {
    ValueNoise noise = new ValueNoise(size).addOctave(new Lattice(256, 32), 1, 77);
    byte[] pores = new byte[size * size];
    for (int i = 0; i < pores.length; i++) {
      double pore = PORE_SLOPE * (noise.at(i % size, i / size) - PORE);
      pores[i] = (byte) (256 * Math.max(0, Math.min(PORE_OPACITY, pore)));
    }
    return pores;
  }

  /**
   * Paints a wall or the ceiling.
   *
   * @param width the width of the texture [texels]; the height is half of the width
   * @param windows the y coordinate of the wall with the windows, in the room frame [m]
   */
  private static int[] texels(int width, Rgb color, Face face, double windows) {
    int[] argb = new int[width * width / 2];
    ValueNoise relief = relief();
    for (int i = 0; i < argb.length; i++) {
      double across = (i % width + 0.5) / width;
      int row = i / width;
      double down = (row + 0.5) / (width / 2.0);
      double y = face.origin().y() + face.right().y() * (across - 0.5) * face.width();
      int column = (int) (across * face.width() * SAMPLES);
      double slope = slope(relief, column, (int) (down * face.height() * SAMPLES));
      double light =
          LOW
              + (1 - LOW) * Math.sqrt(1 - down)
              - Math.min(MOST_FALLOFF, FALLOFF * (windows - y))
              + (slope > 0 ? RELIEF_LIGHT : RELIEF_SHADE) * slope;
      double above = (1 - down) * face.height();
      boolean line = face.up().z() > 0 && above > 0.5 && Math.abs(above - Math.rint(above)) < LINE;
      Rgb plaster = color.shaded(Math.min(1, line ? LINE_SHADE * light : light));
      argb[i] = AmbientOcclusion.shaded(plaster, face, across, 1 - down).argb();
    }
    return argb;
  }

  /** Returns the relief of plaster, with grains of 1 and 2 cm. */
  private static ValueNoise relief() {
    return new ValueNoise(SurfaceTexture.SIZE)
        .addOctave(new Lattice(128, 128), 0.5, 74)
        .addOctave(new Lattice(256, 256), 0.5, 75);
  }

  /**
   * Returns how much the relief at a sample faces the light. The light comes from the upper left.
   */
  private static double slope(ValueNoise relief, int column, int row) {
    return relief.at(column + 1, row + 1) - relief.at(column - 1, row - 1);
  }

  private static double fromWhole(double number) {
    double part = number - (int) number;
    return Math.min(part, 1 - part);
  }
}
