package tellosimulator.video.codec;

import tellosimulator.video.picture.Picture;

/**
 * A picture as the encoder works on it: whole macroblocks, with a border. There are three: the
 * picture to be encoded, what decoders will make of it, and what they made of the one before.
 */
final class Frame {

  /** Decided: how far a prediction may come from beyond the edge, and eight pixels to filter. */
  static final int BORDER = 32;

  final Plane luma;
  final Plane blue;
  final Plane red;
  final int columns;
  final int rows;

  /**
   * @param columns macroblocks from left to right
   * @param rows macroblocks from top to bottom
   */
  Frame(int columns, int rows) {
    this.columns = columns;
    this.rows = rows;
    luma = new Plane(16 * columns, 16 * rows, BORDER);
    blue = new Plane(8 * columns, 8 * rows, BORDER / 2);
    red = new Plane(8 * columns, 8 * rows, BORDER / 2);
  }

  void load(Picture picture) {
    luma.load(picture.y(), picture.width());
    blue.load(picture.u(), picture.width() / 2);
    red.load(picture.v(), picture.width() / 2);
  }

  void extend() {
    luma.extend();
    blue.extend();
    red.extend();
  }
}
