package tellosimulator.video.codec;

import java.util.Arrays;

/**
 * Transforms and quantises the residual of a macroblock, and reconstructs the macroblock. Blocks
 * whose SAD is so small that they would be quantised to zero are skipped before the transform.
 */
final class ResidualCoder {

  /** Decimation score below which an 8x8 luma block is not coded. Decided: as in x264. */
  private static final int LUMA_DECIMATE_THRESHOLD = 4;

  /** Decimation score below which the AC levels of Cb or Cr are not coded. Decided: as in x264. */
  private static final int CHROMA_DECIMATE_THRESHOLD = 7;

  /** The score of a level of 1, by the number of zeros before it. Decided: as in x264. */
  private static final int[] DECIMATE_SCORES = {3, 2, 2, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};

  /** The score of a level above 1. A single such level is sufficient for a block to be coded. */
  private static final int MAX_DECIMATE_SCORE = 9;

  private final MacroblockSamples source;
  private final Residual residual;
  private final Transform transform;
  private final long[] transformed = new long[MacroblockSamples.BLOCKS * Transform.WORDS_PER_BLOCK];
  private final int[] coefficients = new int[MacroblockSamples.BLOCKS * 16];
  private final int[] dc = new int[16];
  private final int[] sads = new int[MacroblockSamples.BLOCKS];

  /**
   * Creates a coder.
   *
   * @param source the samples of the current macroblock
   * @param residual receives the levels
   */
  ResidualCoder(MacroblockSamples source, Residual residual) {
    this.source = source;
    transform = new Transform(source);
    this.residual = residual;
  }

  /** Returns whether the SADs are so small that all blocks are quantised to zero. */
  boolean allZero(MacroblockSamples prediction, QpTables tables) {
    source.blockSads(prediction, sads);
    for (int block = 0; block < MacroblockSamples.CHROMA; block++) {
      if (sads[block] >= tables.lumaZeroSad()) {
        return false;
      }
    }
    for (int block = MacroblockSamples.CHROMA; block < MacroblockSamples.BLOCKS; block++) {
      if (sads[block] >= tables.chromaZeroSad()) {
        return false;
      }
    }
    return true;
  }

  /**
   * Codes the residual of an Inter macroblock.
   *
   * @param prediction the prediction; overwritten with the reconstruction
   */
  void inter(MacroblockSamples prediction, QpTables tables) {
    residual.clear();
    source.blockSads(prediction, sads);
    for (int i = 0; i < 4; i++) {
      if (luma8x8(prediction, tables, (i >> 1) * 8 + (i & 1) * 2)) {
        residual.cbpLuma |= 1 << i;
      }
    }
    chroma(prediction, tables.chroma(), tables.chromaZeroSad());
  }

  /** Codes an 8x8 luma block and returns whether it has nonzero levels. */
  private boolean luma8x8(MacroblockSamples prediction, QpTables tables, int first) {
    int score = 0;
    for (int pair = first; pair < first + 8; pair += 4) {
      if (Math.max(sads[pair], sads[pair + 1]) >= tables.lumaZeroSad()) {
        transform.forward(prediction, pair, transformed);
        score += quantize(tables.luma(), pair, 0) + quantize(tables.luma(), pair + 1, 0);
      }
    }
    for (int i = 0; i < 4; i++) {
      int block = first + (i >> 1) * 4 + (i & 1);
      if (score < LUMA_DECIMATE_THRESHOLD) {
        residual.nonZeroMasks[block] = 0;
      } else if (residual.nonZeroMasks[block] != 0) {
        Transform.addInverse(coefficients, 16 * block, prediction, MacroblockSamples.offset(block));
      }
    }
    return score >= LUMA_DECIMATE_THRESHOLD;
  }

  /** Quantises a block, and returns its decimation score. */
  private int quantize(Quantizer quantizer, int block, int first) {
    quantizer.quantizeBlock(transformed, block, residual, coefficients);
    return score(block, first);
  }

  /** Returns the decimation score of a block, from a scan position on. */
  private int score(int block, int first) {
    int score = 0;
    int next = first;
    for (int left = residual.nonZeroMasks[block]; left != 0; left &= left - 1) {
      int i = Integer.numberOfTrailingZeros(left);
      if (Math.abs(residual.levels[16 * block + Quantizer.zigzag(i)]) > 1) {
        return MAX_DECIMATE_SCORE;
      }
      score += DECIMATE_SCORES[i - next];
      next = i + 1;
    }
    return score;
  }

  /**
   * Codes the residual of an Intra 16x16 macroblock.
   *
   * @param prediction the prediction; overwritten with the reconstruction
   */
  void intra16x16(MacroblockSamples prediction, QpTables tables) {
    residual.clear();
    int anyAc = 0;
    for (int block = 0; block < MacroblockSamples.CHROMA; block++) {
      if ((block & 1) == 0) {
        transform.forward(prediction, block, transformed);
      }
      dc[MacroblockSamples.transposed(block)] = Transform.dc(transformed, block);
      Transform.clearDc(transformed, block);
    }
    tables
        .intraLuma()
        .quantizeBlocks(transformed, 0, MacroblockSamples.CHROMA, residual, coefficients);
    for (int block = 0; block < MacroblockSamples.CHROMA; block++) {
      anyAc |= residual.nonZeroMasks[block];
    }
    residual.cbpLuma = anyAc != 0 ? 15 : 0;
    lumaDc(tables.intraLuma());
    for (int block = 0; block < MacroblockSamples.CHROMA; block++) {
      reconstruct(prediction, block, dc[MacroblockSamples.transposed(block)]);
    }
    source.blockSads(prediction, sads);
    chroma(prediction, tables.intraChroma(), 1);
  }

  private void lumaDc(Quantizer quantizer) {
    Transform.hadamard4x4(dc);
    for (int i = 0; i < 16; i++) {
      residual.dcLevels[i] = (dc[Quantizer.zigzag(i)] + 1) >> 1;
    }
    quantizer.quantizeDc(residual.dcLevels, 0, 16);
    for (int i = 0; i < 16; i++) {
      dc[Quantizer.zigzag(i)] = residual.dcLevels[i];
    }
    Transform.hadamard4x4(dc);
    for (int i = 0; i < 16; i++) {
      dc[i] = quantizer.dequantizeLumaDc(dc[i]);
    }
  }

  /**
   * Codes Cb and Cr. If all blocks of a plane have a SAD below {@code zeroSad}, no levels are coded
   * for that plane.
   */
  private void chroma(MacroblockSamples prediction, Quantizer quantizer, int zeroSad) {
    int cb = chroma(prediction, quantizer, zeroSad, Residual.CB_DC);
    int cr = chroma(prediction, quantizer, zeroSad, Residual.CR_DC);
    residual.cbpChroma = Math.max(cb, cr);
  }

  private int chroma(MacroblockSamples prediction, Quantizer quantizer, int zeroSad, int first) {
    int block = MacroblockSamples.CHROMA + (first == Residual.CR_DC ? 2 : 0);
    int[] levels = residual.dcLevels;
    if (Math.max(Math.max(sads[block], sads[block + 1]), Math.max(sads[block + 4], sads[block + 5]))
        < zeroSad) {
      Arrays.fill(levels, first, first + 4, 0);
      return 0;
    }
    int score = 0;
    for (int i = 0; i < 4; i++) {
      int at = block + (i >> 1) * 4 + (i & 1);
      if ((i & 1) == 0) {
        transform.forward(prediction, at, transformed);
      }
      levels[first + i] = Transform.dc(transformed, at);
      Transform.clearDc(transformed, at);
      score += quantize(quantizer, at, 1);
    }
    Transform.hadamard2x2(levels, first);
    int nonZeroDc = quantizer.quantizeDc(levels, first, 4);
    System.arraycopy(levels, first, dc, 0, 4);
    Transform.hadamard2x2(dc, 0);
    for (int i = 0; i < 4; i++) {
      int at = block + (i >> 1) * 4 + (i & 1);
      if (score < CHROMA_DECIMATE_THRESHOLD) {
        residual.nonZeroMasks[at] = 0;
      }
      reconstruct(prediction, at, quantizer.dequantizeChromaDc(dc[i]));
    }
    return score >= CHROMA_DECIMATE_THRESHOLD ? 2 : nonZeroDc > 0 ? 1 : 0;
  }

  /**
   * Adds the inverse transform of a block to the prediction, including the rescaled DC coefficient.
   */
  private void reconstruct(MacroblockSamples prediction, int block, int first) {
    int at = MacroblockSamples.offset(block);
    if (residual.nonZeroMasks[block] != 0) {
      coefficients[16 * block] = first;
      Transform.addInverse(coefficients, 16 * block, prediction, at);
    } else if (first != 0) {
      Transform.addDcInverse(first, prediction, at);
    }
  }
}
