package tellosimulator.fault;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class StrayDatagramTest {

  /**
   * The first two follow the published rules; the last one is from a capture, with its own data.
   */
  @ParameterizedTest
  @CsvSource({
    "35, 7,    01,   cc 60 00 27 88 35 00 07 00 01 52 50",
    "1a, 8,    5a00, cc 68 00 51 88 1a 00 08 00 5a 00 69 b0",
    "56, 1754, 0000000000000000000000004200005f0f00010000000000,"
        + "cc 18 01 b9 88 56 00 da 06 00 00 00 00 00 00 00 00 00 00 00 00 42 00 00 5f 0f 00 01"
        + " 00 00 00 00 00 ee ef"
  })
  void aFrameHasItsLengthAndChecksums(String id, int sequence, String data, String frame) {
    String bytes = new String(HexFormat.of().parseHex(data), StandardCharsets.ISO_8859_1);

    String framed = StrayDatagram.framed(Integer.parseInt(id, 16), sequence, bytes);

    assertThat(HexFormat.ofDelimiter(" ").formatHex(framed.getBytes(StandardCharsets.ISO_8859_1)))
        .isEqualTo(frame);
  }

  @Test
  void theyHaveTheLengthsThatUsersSee() {
    assertThat(StrayDatagram.of(0)).hasSize(12).startsWith("\u00cc");
    assertThat(StrayDatagram.of(1)).hasSize(13).startsWith("\u00cc");
    assertThat(StrayDatagram.of(2)).hasSize(35).startsWith("\u00cc");
    assertThat(StrayDatagram.of(300)).hasSize(12);
  }
}
