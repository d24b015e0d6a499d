package tellosimulator.video.codec;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BitWriterTest {

  private final BitWriter bits = new BitWriter();

  /** Documented: H.264, table 9-2, and 9-3 for signed numbers. */
  @ParameterizedTest
  @CsvSource({
    "0, 1, 0, 1",
    "1, 010, 1, 010",
    "2, 011, -1, 011",
    "3, 00100, 2, 00100",
    "6, 00111, -3, 00111",
    "7, 0001000, 4, 0001000",
    "254, 000000011111111, -127, 000000011111111"
  })
  void expGolombCodesAreThoseOfTheStandard(int number, String code, int signed, String signedCode) {
    bits.putUe(number);
    bits.putSe(signed);

    assertThat(written()).isEqualTo(code + signedCode);
    assertThat(BitWriter.ueLength(number)).isEqualTo(code.length());
    assertThat(BitWriter.seLength(signed)).isEqualTo(signedCode.length());
  }

  @Test
  void bitStringsOfAnyLengthFollowEachOther() {
    Random random = new Random(3);
    StringBuilder expected = new StringBuilder();
    for (int i = 0; i < 100_000; i++) {
      int length = random.nextInt(33);
      int value = length == 0 ? 0 : random.nextInt() >>> (32 - length);
      bits.reserve(4);
      bits.put(value, length);
      assertThat(bits.bitCount()).isEqualTo(expected.length() + length);
      for (int bit = length - 1; bit >= 0; bit--) {
        expected.append((value >> bit) & 1);
      }
    }

    assertThat(written()).isEqualTo(expected.toString());
  }

  @Test
  void clearDropsWhatWasWritten() {
    bits.put(0x7FFFFFFF, 31);
    bits.clear();
    bits.put(0b101, 3);

    assertThat(written()).isEqualTo("101");
  }

  /** Returns all bits except the final one and the zeros after it. */
  private String written() {
    bits.reserve(8);
    bits.putTrailingBits();
    StringBuilder all = new StringBuilder();
    for (int i = 0; i < bits.size(); i++) {
      for (int bit = 7; bit >= 0; bit--) {
        all.append((bits.bytes()[i] >> bit) & 1);
      }
    }
    return all.substring(0, all.lastIndexOf("1"));
  }
}
