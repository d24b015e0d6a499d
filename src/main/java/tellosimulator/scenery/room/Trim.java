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

/** The trim on the walls: a skirting board, and a horizontal line at each metre. */
final class Trim {

  /** Height of the texture of a line [m]; the visible line is a third of it. Decided: by eye. */
  private static final double LINE = 0.036;

  /** Opacity of the lines. Decided: clearly visible to a camera. */
  private static final double OPACITY = 0.7;

  private static final int SIZE = 16;

  private static final List<Surface> WALLS =
      List.of(Surface.FRONT_WALL, Surface.BACK_WALL, Surface.LEFT_WALL, Surface.RIGHT_WALL);

  private static final Texture LINES = line();
  private static final Texture BOARD = board(Rgb.of(0xe4e0d9));

  private Trim() {}

  /** Returns the skirting board of a room, in the room frame. */
  static Part skirting(Room room) {
    MeshBuilder boards = new MeshBuilder();
    for (Surface wall : WALLS) {
      Face face = Face.of(room, wall);
      boards.quad(face.band(0, PlainTextures.SKIRTING_HEIGHT), TextureRegion.WHOLE);
    }
    return new Part(boards.build(), BOARD, Shading.PANEL);
  }

  /** Returns the lines, in the room frame. */
  static Part lines(Room room) {
    MeshBuilder lines = new MeshBuilder();
    for (Surface wall : WALLS) {
      Face face = Face.of(room, wall);
      for (int meter = 1; meter < room.height(); meter++) {
        lines.quad(face.band(meter - LINE / 2, LINE), TextureRegion.WHOLE);
      }
    }
    return new Part(lines.build(), LINES, Shading.DECAL);
  }

  /**
   * Returns a texture that is transparent except in its middle, so that the line is smooth even
   * from far away.
   */
  private static Texture line() {
    return striped(
        row -> {
          double fromMiddle = Math.abs(row + 0.5 - SIZE / 2.0);
          double part = Math.max(0, Math.min(1, SIZE / 6.0 - fromMiddle + 0.5));
          return Rgb.of(0x2e2c2a).argb(OPACITY * part);
        });
  }

  /**
   * Returns the texture of a skirting board. Its upper edge is dark; a line below it and the lower
   * edge are less dark.
   */
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
