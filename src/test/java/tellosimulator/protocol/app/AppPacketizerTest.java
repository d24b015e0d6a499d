package tellosimulator.protocol.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.util.List;
import org.junit.jupiter.api.Test;

class AppPacketizerTest {

  private final AppPacketizer packetizer = new AppPacketizer();

  private List<byte[]> packets(int type, int length) {
    byte[] unit = new byte[length];
    unit[3] = 1;
    unit[4] = (byte) type;
    return packetizer.packets(ByteBuffer.wrap(unit));
  }

  @Test
  void unitsAreNumberedAndTheirLastDatagramIsMarked() {
    List<byte[]> parameters = packets(7, 13);
    List<byte[]> picture = packets(5, 3000);

    assertThat(parameters).hasSize(1);
    assertThat(parameters.get(0)).startsWith(0, 0x80).hasSize(15);
    assertThat(picture).hasSize(3);
    assertThat(picture.get(0)).startsWith(1, 0).hasSize(1460);
    assertThat(picture.get(1)).startsWith(1, 1).hasSize(1460);
    assertThat(picture.get(2)).startsWith(1, 0x82).hasSize(2 + 3000 - 2 * 1458);
  }

  @Test
  void noPictureFitsInOneDatagram() {
    List<byte[]> picture = packets(1, 40);

    assertThat(picture).hasSize(2);
    assertThat(picture.get(0)).startsWith(0, 0).hasSize(41);
    assertThat(picture.get(1)).startsWith(0, 0x81).hasSize(3);
  }

  @Test
  void numbersWrapAround() {
    for (int i = 0; i < 256; i++) {
      packets(7, 10);
    }

    assertThat(packets(7, 10).get(0)).startsWith(0, 0x80);
  }
}
