package tellosimulator.scenery.room;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntUnaryOperator;
import tellosimulator.scenery.Finish;
import tellosimulator.scenery.Part;
import tellosimulator.scenery.Rgb;
import tellosimulator.scenery.Texture;
import tellosimulator.scenery.room.Quads.Patch;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;

/** What runs around the walls of a textured room: a skirting board, and a line at each metre. */
final class Trim {

  /** Height of the picture of a line [m]; the line itself is a third of it. Decided: by eye. */
  private static final double LINE = 0.036;

  /** Decided: by eye. */
  private static final double LINE_OPACITY = 0.7;

  private static final int PICTURE = 16;

  private static final List<Surface> WALLS =
      List.of(Surface.FRONT_WALL, Surface.BACK_WALL, Surface.LEFT_WALL, Surface.RIGHT_WALL);

  private static final class Pictures {
    static final Texture LINE = line();
    static final Texture BOARD = board();
  }

  private Trim() {}

  /** The parts of a room, room frame. */
  static List<Part> parts(Room room) {
    Quads boards = new Quads();
    Quads lines = new Quads();
    for (Surface wall : WALLS) {
      Face face = Face.of(room, wall);
      boards.add(face.band(0, PlainSurface.SKIRTING_HEIGHT), Patch.WHOLE);
      for (int metre = 1; metre < room.height(); metre++) {
        lines.add(face.band(metre - LINE / 2, LINE), Patch.WHOLE);
      }
    }
    Part board = new Part(boards.mesh(), Pictures.BOARD, Finish.DECAL);
    return room.height() > 1
        ? List.of(board, new Part(lines.mesh(), Pictures.LINE, Finish.DECAL))
        : List.of(board);
  }

  /** Transparent but for its middle, so that it is smooth from far away too. */
  private static Texture line() {
    return striped(
        row -> {
          double fromMiddle = Math.abs(row + 0.5 - PICTURE / 2.0);
          double part = Math.max(0, Math.min(1, PICTURE / 6.0 - fromMiddle + 0.5));
          return Rgb.of(0x2e2c2a).argb(LINE_OPACITY * part);
        });
  }

  /** White, with light on its upper edge and shade below it. */
  private static Texture board() {
    Rgb white = Rgb.of(0xe4e0d8);
    return striped(
        row -> {
          boolean shade = row == 3 || row == PICTURE - 1;
          return (row < 1 ? white.shaded(0.55) : shade ? white.shaded(0.75) : white).argb();
        });
  }

  private static Texture striped(IntUnaryOperator row) {
    int[] pixels = new int[PICTURE * PICTURE];
    Arrays.setAll(pixels, i -> row.applyAsInt(i / PICTURE));
    return new Texture(PICTURE, PICTURE, pixels);
  }
}
