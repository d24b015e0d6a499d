package tellosimulator.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PacketizerTest {

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          1,    1
          1459, 1459
          1461, 1460 1
          2919, 1460 1459
          4000, 1460 1460 1080
          1460, 1460 1
          2920, 1460 1460 1
          """)
  void theLastDatagramIsAlwaysShorter(int length, String lengths) {
    List<byte[]> packets = Packetizer.RAW.packets(ByteBuffer.wrap(new byte[length]));

    assertThat(packets.stream().map(packet -> Integer.toString(packet.length)))
        .containsExactly(lengths.split(" "));
  }

  @ParameterizedTest
  @CsvSource({"13, 0", "2919, 0", "2920, 1"})
  void putTogetherTheyAreTheNalUnitAndAtMostOneZeroByte(int length, int zeros) {
    byte[] stream = new byte[length + 40];
    new Random(1).nextBytes(stream);
    ByteArrayOutputStream together = new ByteArrayOutputStream();

    Packetizer.RAW.packets(ByteBuffer.wrap(stream, 20, length)).forEach(together::writeBytes);

    byte[] expected = new byte[length + zeros];
    System.arraycopy(stream, 20, expected, 0, length);
    assertThat(together.toByteArray()).isEqualTo(expected);
  }
}
