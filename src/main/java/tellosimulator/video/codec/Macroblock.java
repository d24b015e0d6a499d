package tellosimulator.video.codec;

/**
 * The macroblock that is being coded: 16 by 16 pixels. One object serves all of a picture, one
 * after another; who decides fills it in, and {@link MacroblockWriter} writes it.
 */
final class Macroblock {

  /** What it shall look like. */
  final Samples source = new Samples();

  /** What its prediction lacks. */
  final Residual residual = new Residual();

  /** Its place from the left. */
  int column;

  /** Its place from the top. */
  int row;

  Quality quality;

  /** How its vector differs from the one that is expected, in quarters of a pixel. */
  int differenceX;

  /** How its vector differs from the one that is expected, in quarters of a pixel. */
  int differenceY;

  /** How its luma is predicted from the same picture: H.264, table 8-4. */
  int lumaMode;

  /** How its colours are predicted from the same picture: H.264, table 8-5. */
  int colourMode;

  /** Goes on to a place and takes over what is there. */
  void take(Frame frame, int newColumn, int newRow) {
    column = newColumn;
    row = newRow;
    source.load(frame, column, row);
  }
}
