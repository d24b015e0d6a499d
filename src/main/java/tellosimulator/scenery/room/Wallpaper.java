package tellosimulator.scenery.room;

import tellosimulator.scenery.Texture;

/** The patterns on walls and ceiling; each is drawn when it is first needed, and then kept. */
final class Wallpaper {

  /** Edge of the square that repeats [m]. Decided: whole metres, so that it meets metre lines. */
  static final double TILE = 2;

  /** The same [pixels]. Decided: sharp from a metre away. */
  static final int SIZE = 512;

  /** Edge of a pixel [m]. */
  static final double PIXEL = TILE / SIZE;

  private static final class Front {
    static final Texture BRICKS = Brickwork.texture();
  }

  private static final class Back {
    static final Texture HEXAGONS = Hexagons.texture();
  }

  private static final class Left {
    static final Texture BOARDS = Boards.texture();
  }

  private static final class Right {
    static final Texture TRIANGLES = Triangles.texture();
  }

  private static final class Above {
    static final Texture PANELS = CeilingPanels.texture();
  }

  private Wallpaper() {}

  static Texture bricks() {
    return Front.BRICKS;
  }

  static Texture hexagons() {
    return Back.HEXAGONS;
  }

  static Texture boards() {
    return Left.BOARDS;
  }

  static Texture triangles() {
    return Right.TRIANGLES;
  }

  static Texture panels() {
    return Above.PANELS;
  }
}
