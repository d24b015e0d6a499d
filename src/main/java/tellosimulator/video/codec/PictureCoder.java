package tellosimulator.video.codec;

/** Decides how each macroblock is told, codes it, and so makes the picture that decoders see. */
final class PictureCoder {

  /** Differences below are not worth looking for a prediction from the same picture. */
  private static final int GOOD = 4 * 256;

  private final MotionField field;
  private final MotionSearch search;
  private final IntraPrediction intra = new IntraPrediction();
  private final Macroblock macroblock = new Macroblock();
  private final ResidualCoder residuals = new ResidualCoder(macroblock.source, macroblock.residual);
  private final MacroblockWriter writer;
  private final Samples prediction = new Samples();
  private final Frame source;
  private Frame coded;
  private Frame reference;

  PictureCoder(Frame source, MacroblockWriter writer) {
    this.source = source;
    this.writer = writer;
    field = new MotionField(source.columns, source.rows);
    search = new MotionSearch(field);
    coded = new Frame(source.columns, source.rows);
    reference = new Frame(source.columns, source.rows);
  }

  /** Begins a picture; the last one is its reference. */
  void next() {
    Frame swap = reference;
    reference = coded;
    coded = swap;
    field.next();
  }

  /** The picture as decoders see it. */
  Frame coded() {
    return coded;
  }

  /** Codes a row of macroblocks. */
  void row(int row, boolean key, Quality quality) {
    macroblock.quality = quality;
    for (int column = 0; column < source.columns; column++) {
      macroblock.take(source, column, row);
      if (key) {
        codeIntra();
      } else {
        code();
      }
      prediction.store(coded, column, row);
    }
  }

  private void codeIntra() {
    intra.luma(coded, macroblock, prediction);
    finishIntra();
  }

  private void finishIntra() {
    intra.colour(coded, macroblock, prediction);
    residuals.intra(prediction, macroblock.quality);
    field.setIntra(index());
    writer.intra(macroblock);
  }

  private void code() {
    field.expect(macroblock.column, macroblock.row);
    search.begin(reference, macroblock);
    if (search.reachable(field.skipX, field.skipY)) {
      search.predict(field.skipX, field.skipY, prediction);
      if (residuals.quiet(prediction, macroblock.quality)) {
        skip();
        return;
      }
    }
    search.search();
    if (search.difference > GOOD
        && intra.luma(coded, macroblock, prediction) + 8 * macroblock.quality.lambda()
            < search.cost) {
      finishIntra();
      return;
    }
    codeInter();
  }

  private void skip() {
    field.set(index(), field.skipX, field.skipY);
    writer.skip(macroblock);
  }

  private void codeInter() {
    search.predict(search.x, search.y, prediction);
    residuals.inter(prediction, macroblock.quality);
    if (macroblock.residual.pattern() == 0 && search.x == field.skipX && search.y == field.skipY) {
      skip();
      return;
    }
    macroblock.differenceX = search.x - field.expectedX;
    macroblock.differenceY = search.y - field.expectedY;
    field.set(index(), search.x, search.y);
    writer.inter(macroblock);
  }

  private int index() {
    return macroblock.row * source.columns + macroblock.column;
  }
}
