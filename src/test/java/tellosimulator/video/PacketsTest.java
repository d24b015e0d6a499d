package tellosimulator.video;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PacketsTest {

  @Test
  void parameterSetsTravelAloneAndThePictureBeginsInTheNextDatagram() {
    List<byte[]> packets = Packets.of(FakePicture.of(13, 8, 4000));

    assertThat(packets)
        .extracting(packet -> packet.length)
        .containsExactly(13, 8, 1460, 1460, 1080);
  }

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          1,    1
          1459, 1459
          1461, 1460 1
          2919, 1460 1459
          1460, 1460 1
          2920, 1460 1460 1
          """)
  void theLastDatagramIsAlwaysShorter(int length, String lengths) {
    List<byte[]> packets = Packets.of(FakePicture.of(length));

    assertThat(packets.stream().map(packet -> Integer.toString(packet.length)))
        .containsExactly(lengths.split(" "));
  }

  @Test
  void putTogetherTheyAreThePictureAndAtMostOneZeroByte() {
    FakePicture picture = FakePicture.of(13, 8, 2920);
    ByteArrayOutputStream together = new ByteArrayOutputStream();
    Packets.of(picture).forEach(together::writeBytes);

    byte[] bytes = together.toByteArray();
    assertThat(bytes).hasSize(13 + 8 + 2920 + 1).endsWith(0);
    assertThat(Arrays.copyOf(bytes, picture.size()))
        .isEqualTo(Arrays.copyOf(picture.bytes(), picture.size()));
  }
}
