package tellosimulator.video.codec;

import java.util.Arrays;

/**
 * Turns what a prediction lacks into levels, and the prediction into what decoders will see. Blocks
 * that are as good as predicted are left out before anything is transformed.
 */
final class ResidualCoder {

  /** Levels worth less are not sent for a quarter of luma. Decided, as x264 does. */
  private static final int WORTHWHILE = 4;

  /** Levels worth less are not sent for a colour. Decided, as x264 does. */
  private static final int WORTHWHILE_COLOUR = 7;

  /** What a level of 1 is worth after so many zeros. Decided, as x264 does. */
  private static final int[] WORTH = {3, 2, 2, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};

  /** What a larger level is worth: enough in any case. */
  private static final int LARGE = 9;

  private final Samples source;
  private final Residual residual;
  private final Transform transform;
  private final long[] words = new long[Samples.BLOCKS * Transform.WORDS];
  private final int[] coefficients = new int[Samples.BLOCKS * 16];
  private final int[] corners = new int[16];
  private final int[] sums = new int[Samples.BLOCKS];

  /**
   * @param source the macroblock that is coded
   * @param residual gets the levels
   */
  ResidualCoder(Samples source, Residual residual) {
    this.source = source;
    transform = new Transform(source);
    this.residual = residual;
  }

  /** Whether nothing need be sent. */
  boolean quiet(Samples prediction, Quality quality) {
    source.differences(prediction, sums);
    for (int block = 0; block < Samples.COLOUR; block++) {
      if (sums[block] >= quality.quietLuma()) {
        return false;
      }
    }
    for (int block = Samples.COLOUR; block < Samples.BLOCKS; block++) {
      if (sums[block] >= quality.quietColour()) {
        return false;
      }
    }
    return true;
  }

  /**
   * Codes a macroblock that was predicted from another picture.
   *
   * @param prediction becomes what decoders see
   */
  void inter(Samples prediction, Quality quality) {
    residual.clear();
    source.differences(prediction, sums);
    for (int quarter = 0; quarter < 4; quarter++) {
      if (quarter(prediction, quality, (quarter >> 1) * 8 + (quarter & 1) * 2)) {
        residual.lumaPattern |= 1 << quarter;
      }
    }
    colour(prediction, quality.colour(), quality.quietColour());
  }

  /** Codes a quarter of luma; whether anything is sent for it. */
  private boolean quarter(Samples prediction, Quality quality, int first) {
    int worth = 0;
    for (int pair = first; pair < first + 8; pair += 4) {
      if (Math.max(sums[pair], sums[pair + 1]) >= quality.quietLuma()) {
        transform.forward(prediction, pair, words);
        worth += quantize(quality.luma(), pair, 0) + quantize(quality.luma(), pair + 1, 0);
      }
    }
    for (int i = 0; i < 4; i++) {
      int block = first + (i >> 1) * 4 + (i & 1);
      if (worth < WORTHWHILE) {
        residual.masks[block] = 0;
      } else if (residual.masks[block] != 0) {
        Transform.addInverse(coefficients, 16 * block, prediction, Samples.at(block));
      }
    }
    return worth >= WORTHWHILE;
  }

  /** Finds a block's levels; how much they are worth. */
  private int quantize(Quantizer quantizer, int block, int first) {
    quantizer.block(words, block, residual, coefficients);
    return worth(block, first);
  }

  /** How much a block's levels are worth; much if one is above 1. */
  private int worth(int block, int first) {
    int worth = 0;
    int next = first;
    for (int left = residual.masks[block]; left != 0; left &= left - 1) {
      int i = Integer.numberOfTrailingZeros(left);
      if (Math.abs(residual.levels[16 * block + Quantizer.place(i)]) > 1) {
        return LARGE;
      }
      worth += WORTH[i - next];
      next = i + 1;
    }
    return worth;
  }

  /**
   * Codes a macroblock whose luma was predicted as a whole from the same picture.
   *
   * @param prediction becomes what decoders see
   */
  void intra(Samples prediction, Quality quality) {
    residual.clear();
    int any = 0;
    for (int block = 0; block < Samples.COLOUR; block++) {
      if ((block & 1) == 0) {
        transform.forward(prediction, block, words);
      }
      corners[Samples.turned(block)] = Transform.first(words, block);
      Transform.dropFirst(words, block);
    }
    quality.intraLuma().blocks(words, 0, Samples.COLOUR, residual, coefficients);
    for (int block = 0; block < Samples.COLOUR; block++) {
      any |= residual.masks[block];
    }
    residual.lumaPattern = any != 0 ? 15 : 0;
    lumaFirsts(quality.intraLuma());
    for (int block = 0; block < Samples.COLOUR; block++) {
      add(prediction, block, corners[Samples.turned(block)]);
    }
    source.differences(prediction, sums);
    colour(prediction, quality.intraColour(), 1);
  }

  private void lumaFirsts(Quantizer quantizer) {
    Transform.hadamard(corners);
    for (int i = 0; i < 16; i++) {
      residual.first[i] = (corners[Quantizer.place(i)] + 1) >> 1;
    }
    quantizer.first(residual.first, 0, 16);
    for (int i = 0; i < 16; i++) {
      corners[Quantizer.place(i)] = residual.first[i];
    }
    Transform.hadamard(corners);
    for (int i = 0; i < 16; i++) {
      corners[i] = quantizer.lumaFirst(corners[i]);
    }
  }

  /** Codes both colours; one with smaller differences than quiet has no levels. */
  private void colour(Samples prediction, Quantizer quantizer, int quiet) {
    int blue = colour(prediction, quantizer, quiet, Residual.BLUE);
    int red = colour(prediction, quantizer, quiet, Residual.RED);
    residual.colourPattern = Math.max(blue, red);
  }

  private int colour(Samples prediction, Quantizer quantizer, int quiet, int first) {
    int block = Samples.COLOUR + (first == Residual.RED ? 2 : 0);
    int[] levels = residual.first;
    if (Math.max(Math.max(sums[block], sums[block + 1]), Math.max(sums[block + 4], sums[block + 5]))
        < quiet) {
      Arrays.fill(levels, first, first + 4, 0);
      return 0;
    }
    int worth = 0;
    for (int i = 0; i < 4; i++) {
      int at = block + (i >> 1) * 4 + (i & 1);
      if ((i & 1) == 0) {
        transform.forward(prediction, at, words);
      }
      levels[first + i] = Transform.first(words, at);
      Transform.dropFirst(words, at);
      worth += quantize(quantizer, at, 1);
    }
    Transform.smallHadamard(levels, first);
    int firsts = quantizer.first(levels, first, 4);
    System.arraycopy(levels, first, corners, 0, 4);
    Transform.smallHadamard(corners, 0);
    for (int i = 0; i < 4; i++) {
      int at = block + (i >> 1) * 4 + (i & 1);
      if (worth < WORTHWHILE_COLOUR) {
        residual.masks[at] = 0;
      }
      add(prediction, at, quantizer.colourFirst(corners[i]));
    }
    return worth >= WORTHWHILE_COLOUR ? 2 : firsts > 0 ? 1 : 0;
  }

  /** Adds what decoders make of a block's levels and of its first coefficient. */
  private void add(Samples prediction, int block, int first) {
    int at = Samples.at(block);
    if (residual.masks[block] != 0) {
      coefficients[16 * block] = first;
      Transform.addInverse(coefficients, 16 * block, prediction, at);
    } else if (first != 0) {
      Transform.addFirst(first, prediction, at);
    }
  }
}
