package tellosimulator.video.codec;

/**
 * The current macroblock: source samples, coding decisions and residual. One object is used for all
 * macroblocks of a slice in turn. {@link SliceEncoder} fills it in, and {@link MacroblockWriter}
 * writes it.
 */
final class Macroblock {

  final MacroblockSamples source = new MacroblockSamples();
  final Residual residual = new Residual();

  /** Column [macroblocks]. */
  int mbX;

  /** Row [macroblocks]. */
  int mbY;

  QpTables tables;

  /** Horizontal motion vector difference [quarter samples]. */
  int mvdX;

  /** Vertical motion vector difference [quarter samples]. */
  int mvdY;

  /** The Intra16x16PredMode (H.264, table 8-4). */
  int intra16x16PredMode;

  /** The intra_chroma_pred_mode (H.264, table 8-5). */
  int intraChromaPredMode;

  /** Moves on to another macroblock, and loads its source samples. */
  void load(Frame frame, int newMbX, int newMbY) {
    mbX = newMbX;
    mbY = newMbY;
    source.load(frame, mbX, mbY);
  }
}
