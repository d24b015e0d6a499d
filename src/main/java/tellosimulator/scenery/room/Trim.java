package tellosimulator.scenery.room;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntUnaryOperator;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.TextureRegion;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;

/** The trim of walls: a skirting board, and a line at each metre. */
enum Trim {
  /** Lines that a camera sees. */
  TEXTURED(0.7, Rgb.of(0xe4e0d8)),
  /** Lines that one sees who looks for them. */
  CALM(0.13, Rgb.of(0xe4e0d9));

  /** Height of the texture of a line [m]; the line itself is a third of it. Decided: by eye. */
  private static final double LINE = 0.036;

  private static final int SIZE = 16;

  private static final List<Surface> WALLS =
      List.of(Surface.FRONT_WALL, Surface.BACK_WALL, Surface.LEFT_WALL, Surface.RIGHT_WALL);

  private final Texture line;
  private final Texture board;

  /**
   * @param lineOpacity 0 to 1. Decided: by eye, as the colour of the board
   */
  Trim(double lineOpacity, Rgb board) {
    line = line(lineOpacity);
    this.board = board(board);
  }

  /** The parts of a room, room frame. */
  List<Part> parts(Room room) {
    MeshBuilder boards = new MeshBuilder();
    MeshBuilder lines = new MeshBuilder();
    for (Surface wall : WALLS) {
      Face face = Face.of(room, wall);
      boards.quad(face.band(0, PlainTextures.SKIRTING_HEIGHT), TextureRegion.WHOLE);
      for (int meter = 1; meter < room.height(); meter++) {
        lines.quad(face.band(meter - LINE / 2, LINE), TextureRegion.WHOLE);
      }
    }
    Part skirting = new Part(boards.build(), board, Shading.DECAL);
    return room.height() > 1
        ? List.of(skirting, new Part(lines.build(), line, Shading.DECAL))
        : List.of(skirting);
  }

  /** Transparent but for its middle, so that it is smooth from far away too. */
  private static Texture line(double opacity) {
    return striped(
        row -> {
          double fromMiddle = Math.abs(row + 0.5 - SIZE / 2.0);
          double part = Math.max(0, Math.min(1, SIZE / 6.0 - fromMiddle + 0.5));
          return Rgb.of(0x2e2c2a).argb(opacity * part);
        });
  }

  /** With light on its upper edge and shade below it. */
  private static Texture board(Rgb white) {
    return striped(
        row -> {
          boolean shade = row == 3 || row == SIZE - 1;
          return (row < 1 ? white.shaded(0.55) : shade ? white.shaded(0.75) : white).argb();
        });
  }

  private static Texture striped(IntUnaryOperator row) {
    int[] pixels = new int[SIZE * SIZE];
    Arrays.setAll(pixels, i -> row.applyAsInt(i / SIZE));
    return new Texture(SIZE, SIZE, pixels);
  }
}
