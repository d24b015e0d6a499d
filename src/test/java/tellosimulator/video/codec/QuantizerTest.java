package tellosimulator.video.codec;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class QuantizerTest {

  private static final int BLOCKS = Samples.COLOUR;

  private final Residual together = new Residual();
  private final Residual apart = new Residual();
  private final int[] decoded = new int[16 * BLOCKS];
  private final int[] decodedApart = new int[16 * BLOCKS];

  @ParameterizedTest
  @ValueSource(ints = {10, 17, 26, 39, 51})
  void aBlockAloneGivesWhatItGivesTogether(int qp) {
    long[] words = words(qp);
    Quantizer quantizer = new Quantizer(qp, 2);

    quantizer.blocks(words, 0, BLOCKS, together, decoded);
    for (int block = 0; block < BLOCKS; block++) {
      quantizer.block(words, block, apart, decodedApart);
    }

    assertThat(apart.masks).isEqualTo(together.masks);
    assertThat(Arrays.stream(apart.masks).limit(BLOCKS)).contains(0).anyMatch(mask -> mask != 0);
    assertThat(apart.levels).isEqualTo(together.levels);
    assertThat(decodedApart).isEqualTo(decoded);
  }

  /** A block that would have no levels is left out before they are computed. */
  @ParameterizedTest
  @ValueSource(ints = {10, 17, 26, 39, 51})
  void aSingleCoefficientCountsAloneAsItDoesTogether(int qp) {
    Quantizer quantizer = new Quantizer(qp, 2);
    long[] words = new long[Transform.WORDS * BLOCKS];
    for (int size = 0; size < 10 * Math.pow(2, qp / 6.0); size++) {
      for (int block = 0; block < BLOCKS; block++) {
        int value = block % 3 == 0 ? -size : size;
        words[Transform.WORDS * block + block / 4] = value * (1L << (16 * (block % 4)));
        quantizer.block(words, block, apart, decodedApart);
      }
      quantizer.blocks(words, 0, BLOCKS, together, decoded);

      assertThat(apart.masks).isEqualTo(together.masks);
    }
    assertThat(Arrays.stream(apart.masks).limit(BLOCKS)).doesNotContain(0);
  }

  @ParameterizedTest
  @ValueSource(ints = {10, 26, 51})
  void masksTellInZigzagOrderWhichLevelsAreNotZero(int qp) {
    new Quantizer(qp, 1).blocks(words(qp), 0, BLOCKS, together, decoded);

    for (int block = 0; block < BLOCKS; block++) {
      for (int i = 0; i < 16; i++) {
        boolean there = together.levels[16 * block + Quantizer.place(i)] != 0;
        assertThat((together.masks[block] >> i & 1) == 1).isEqualTo(there);
      }
    }
  }

  /** Blocks of which the first hold nothing that counts, and the later ones ever more. */
  private static long[] words(int qp) {
    Random random = new Random(qp);
    double step = Math.pow(2, qp / 6.0);
    long[] words = new long[Transform.WORDS * BLOCKS];
    for (int i = 0; i < words.length; i++) {
      int block = i / Transform.WORDS;
      int most = (int) Math.min(10_000, 1 + step * block);
      for (int lane = 0; lane < 4; lane++) {
        words[i] += (random.nextInt(2 * most + 1) - most) * (1L << (16 * lane));
      }
    }
    return words;
  }
}
