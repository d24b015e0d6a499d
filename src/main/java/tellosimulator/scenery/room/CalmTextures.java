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
 * The textures of calm rooms: light oak, and plaster that is a little darker near the floor. The
 * front wall has an accent colour, and the others differ in brightness as if light came from one
 * side. Decided: all of it, by eye.
 */
final class CalmTextures {

  /** Edge of the texture of a wall [texels]. Decided: it has no fine detail. */
  private static final int PLASTER_SIZE = 128;

  /** Boards in a tile, so each is 10 cm wide. */
  private static final int BOARDS = 20;

  /** Boards in a tile one behind the other, so each is 1 m long. */
  private static final int LENGTHS = 2;

  /** How far a board is shifted against that at its left, in lengths: the golden ratio. */
  private static final double SHIFT = 0.618;

  private static final ColorRamp OAK = new ColorRamp(Rgb.of(0xc3ab8b), Rgb.of(0xdbc8ac));
  private static final int JOINT = Rgb.of(0xb09a7d).argb();

  /** How far a joint is to be seen [texels]. */
  private static final double JOINT_WIDTH = 1.3;

  static final Rgb ACCENT = Rgb.of(0xaabfb0);
  private static final Rgb PLASTER = Rgb.of(0xf0ede7);
  private static final Rgb CEILING = Rgb.of(0xf4f2ee);

  /** Brightness at the foot of a wall, compared with its top. */
  private static final double LOW = 0.94;

  private static final double UNEVEN = 0.012;

  /** What is the same for all rooms; computed for the first one. */
  private static final class Shared {

    static final Texture BOARDS = ProceduralTexture.of(SurfaceTexture.SIZE, CalmTextures::oak);

    static final ValueNoise PLASTER_NOISE =
        new ValueNoise(PLASTER_SIZE)
            .addOctave(new Lattice(16, 8), UNEVEN / 2, 74)
            .addOctave(new Lattice(64, 64), UNEVEN / 2, 75);
  }

  private CalmTextures() {}

  /** A tile of the floor, without lines; its boards lead to the front wall. */
  static Texture boards() {
    return Shared.BOARDS;
  }

  /** What the textures of a calm room's walls depend on. */
  record Plaster(Room room, OptionalInt accent) {}

  /** Each wall and the ceiling as a whole, with the ambient occlusion in the room's corners. */
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
        textures.put(surface, plaster(color, Face.of(walls.room, surface)));
      }
    }
    return textures;
  }

  private static ProceduralTexture.Texels oak() {
    int size = SurfaceTexture.SIZE;
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
      return ProceduralTexture.mix(
          JOINT, OAK.argb(tone + 0.25 * grain.at(x, y + 61 * board)), fromJoint / JOINT_WIDTH);
    };
  }

  private static Texture plaster(Rgb color, Face face) {
    return ProceduralTexture.of(
        PLASTER_SIZE,
        () ->
            (x, y) -> {
              double up = 1 - (y + 0.5) / PLASTER_SIZE;
              double light =
                  LOW + (1 - LOW) * Math.sqrt(up) - UNEVEN + Shared.PLASTER_NOISE.at(x, y);
              double across = (x + 0.5) / PLASTER_SIZE;
              return AmbientOcclusion.shaded(color.shaded(light), face, across, up).argb();
            });
  }

  private static double fromWhole(double number) {
    double part = number - (int) number;
    return Math.min(part, 1 - part);
  }
}
