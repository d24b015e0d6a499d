package tellosimulator.video.codec;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.HexFormat;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class AnnexBWriterTest {

  private final AnnexBWriter writer = new AnnexBWriter();

  /** Documented: H.264, 7.4.1: a 3 comes between two zeros and a byte of at most 3. */
  @ParameterizedTest
  @CsvSource({
    "000001, 00000301",
    "000002, 00000302",
    "000003, 00000303",
    "000004, 000004",
    "00000001, 0000030001",
    "000000000001, 0000030000030001",
    "0000000000000001, 0000030000030000030001",
    "010000000180, 01000003000180",
    "FF00, FF00",
    "0100FF0001, 0100FF0001"
  })
  void emulationPreventionBytesBreakUpStartCodes(String payload, String escaped) {
    byte[] bytes = HexFormat.of().parseHex(payload);
    writer.begin(true);

    writer.add(0x65, bytes, bytes.length);

    assertThat(written()).isEqualTo("0000000165" + escaped);
  }

  @Test
  void eachNalUnitBeginsWhereTheOneBeforeEnds() {
    writer.begin(true);
    writer.add(0x67, new byte[] {1}, 1);
    writer.add(0x68, new byte[] {2, 3, 4}, 2);

    assertThat(writer.nalUnits()).isEqualTo(2);
    assertThat(written()).isEqualTo("000000016701" + "00000001680203");
    assertThat(new int[] {writer.start(0), writer.start(1), writer.start(2)})
        .containsExactly(0, 6, 6 + 7);
  }

  @Test
  void beginDropsTheAccessUnitBefore() {
    writer.begin(true);
    writer.add(0x65, new byte[] {1}, 1);
    writer.begin(false);
    writer.add(0x41, new byte[] {2}, 1);

    assertThat(writer.idr()).isFalse();
    assertThat(written()).isEqualTo("000000014102");
  }

  @Test
  void theBufferGrowsBeyondWhatAnyFrameNeeds() {
    byte[] zeros = new byte[1_000_000];
    writer.begin(true);
    writer.add(0x65, zeros, zeros.length);

    assertThat(writer.size()).as("a 3 after each two zeros").isEqualTo(5 + 1_500_000 - 1);
  }

  private String written() {
    return HexFormat.of().withUpperCase().formatHex(Arrays.copyOf(writer.bytes(), writer.size()));
  }
}
