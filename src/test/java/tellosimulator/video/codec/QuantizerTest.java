package tellosimulator.video.codec;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class QuantizerTest {

  private static final int BLOCKS = MacroblockSamples.CHROMA;

  private final Residual batch = new Residual();
  private final Residual single = new Residual();
  private final int[] rescaled = new int[16 * BLOCKS];
  private final int[] rescaledSingle = new int[16 * BLOCKS];

  @ParameterizedTest
  @ValueSource(ints = {10, 17, 26, 39, 51})
  void quantizingOneBlockGivesTheSameAsQuantizingAll(int qp) {
    long[] transformed = transformed(qp);
    Quantizer quantizer = new Quantizer(qp, 2);

    quantizer.quantizeBlocks(transformed, 0, BLOCKS, batch, rescaled);
    for (int block = 0; block < BLOCKS; block++) {
      quantizer.quantizeBlock(transformed, block, single, rescaledSingle);
    }

    assertThat(single.nonZeroMasks).isEqualTo(batch.nonZeroMasks);
    assertThat(Arrays.stream(single.nonZeroMasks).limit(BLOCKS))
        .contains(0)
        .anyMatch(nonZeroMask -> nonZeroMask != 0);
    assertThat(single.levels).isEqualTo(batch.levels);
    assertThat(rescaledSingle).isEqualTo(rescaled);
  }

  /** The zero test before quantisation must agree with quantisation, coefficient by coefficient. */
  @ParameterizedTest
  @ValueSource(ints = {10, 17, 26, 39, 51})
  void aBlockSkippedAsAllZeroWouldHaveNoLevels(int qp) {
    Quantizer quantizer = new Quantizer(qp, 2);
    long[] transformed = new long[Transform.WORDS_PER_BLOCK * BLOCKS];
    for (int size = 0; size < 10 * Math.pow(2, qp / 6.0); size++) {
      for (int block = 0; block < BLOCKS; block++) {
        int value = block % 3 == 0 ? -size : size;
        transformed[Transform.WORDS_PER_BLOCK * block + block / 4] =
            value * (1L << (16 * (block % 4)));
        quantizer.quantizeBlock(transformed, block, single, rescaledSingle);
      }
      quantizer.quantizeBlocks(transformed, 0, BLOCKS, batch, rescaled);

      assertThat(single.nonZeroMasks).isEqualTo(batch.nonZeroMasks);
    }
    assertThat(Arrays.stream(single.nonZeroMasks).limit(BLOCKS)).doesNotContain(0);
  }

  @ParameterizedTest
  @ValueSource(ints = {10, 26, 51})
  void masksMarkNonZeroLevelsInZigzagOrder(int qp) {
    new Quantizer(qp, 1).quantizeBlocks(transformed(qp), 0, BLOCKS, batch, rescaled);

    for (int block = 0; block < BLOCKS; block++) {
      for (int i = 0; i < 16; i++) {
        boolean there = batch.levels[16 * block + Quantizer.zigzag(i)] != 0;
        assertThat((batch.nonZeroMasks[block] >> i & 1) == 1).isEqualTo(there);
      }
    }
  }

  /**
   * Returns blocks of which the first quantise to zero, and the later ones to increasingly many
   * levels.
   */
  private static long[] transformed(int qp) {
    Random random = new Random(qp);
    double stepSize = Math.pow(2, qp / 6.0);
    long[] transformed = new long[Transform.WORDS_PER_BLOCK * BLOCKS];
    for (int i = 0; i < transformed.length; i++) {
      int block = i / Transform.WORDS_PER_BLOCK;
      int most = (int) Math.min(10_000, 1 + stepSize * block);
      for (int lane = 0; lane < 4; lane++) {
        transformed[i] += (random.nextInt(2 * most + 1) - most) * (1L << (16 * lane));
      }
    }
    return transformed;
  }
}
