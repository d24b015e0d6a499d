package tellosimulator.video.codec;

/** Decides how each macroblock is told, codes it, and so makes the picture that decoders see. */
final class PictureCoder {

  /**
   * Differences below are not worth looking for a prediction from the same picture. Measured: 4 a
   * pixel instead of 10 takes 4 % longer for 0.1 dB.
   */
  private static final int GOOD = 10 * 256;

  /**
   * Half of what may be left of 16 blocks without any level: below it, nothing better than the
   * expected vector is looked for. Measured: 0.03 dB for 4 % of the time.
   */
  private static final int QUIET_BLOCKS = 8;

  /** What it takes to say that a macroblock is predicted from the same picture, about. */
  private static final int INTRA_BITS = 8;

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
      Samples seen = key ? intra() : any();
      seen.store(coded, column, row);
    }
  }

  /** Codes a macroblock from its neighbours; how decoders see it. */
  private Samples intra() {
    intra.luma(coded, macroblock, prediction);
    return finishIntra();
  }

  private Samples finishIntra() {
    intra.colour(coded, macroblock, prediction);
    residuals.intra(prediction, macroblock.quality);
    field.setIntra(index());
    writer.intra(macroblock);
    return prediction;
  }

  /** Codes a macroblock in the cheapest way; how decoders see it. */
  private Samples any() {
    field.expect(macroblock.column, macroblock.row);
    search.begin(reference, macroblock);
    boolean tried = search.trySkip();
    if (tried && residuals.quiet(search.found(), macroblock.quality)) {
      return skip();
    }
    if (!tried || search.difference >= QUIET_BLOCKS * macroblock.quality.quietLuma()) {
      search.search();
    }
    if (search.difference > GOOD
        && intra.luma(coded, macroblock, prediction) + INTRA_BITS * macroblock.quality.lambda()
            < search.cost) {
      return finishIntra();
    }
    return inter();
  }

  private Samples skip() {
    field.set(index(), field.skipX, field.skipY);
    writer.skip(macroblock);
    return search.found();
  }

  private Samples inter() {
    search.predictColour();
    residuals.inter(search.found(), macroblock.quality);
    if (macroblock.residual.pattern() == 0 && search.x == field.skipX && search.y == field.skipY) {
      return skip();
    }
    macroblock.differenceX = search.x - field.expectedX;
    macroblock.differenceY = search.y - field.expectedY;
    field.set(index(), search.x, search.y);
    writer.inter(macroblock);
    return search.found();
  }

  private int index() {
    return macroblock.row * source.columns + macroblock.column;
  }
}
