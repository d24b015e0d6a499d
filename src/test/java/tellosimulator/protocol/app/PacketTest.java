package tellosimulator.protocol.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HexFormat;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PacketTest {

  private static byte[] bytes(String hex) {
    return HexFormat.of().parseHex(hex.replace(" ", ""));
  }

  private static String hex(byte[] bytes) {
    return HexFormat.of().formatHex(bytes);
  }

  /**
   * Packets of real drones and clients: SMerrony/tello, TelloLib, a radio capture, TelloPy 25, 48.
   */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "cc 58 00 7c 68 54 00 00 00 b2 89",
        "cc 58 00 7c 68 54 00 e4 01 c2 16",
        "cc 60 00 27 68 55 00 e5 01 00 ba c7",
        "cc 58 00 7c 60 25 00 00 00 6c 95",
        "cc b0 00 7f 60 50 00 00 00 00 04 20 00 01 08 08 16 0f 45 02 0a 3d",
        "cc 18 01 b9 88 56 00 da 06 00 00 00 00 00 00 00 00 00 00 00 00 42 00 00 5f 0f 00 01 00 00"
            + "00 00 00 ee ef",
        "cc 60 00 27 90 34 00 00 00 00 72 a5",
        "cc 60 00 27 b0 20 00 00 00 00 42 b9",
        "cc 60 00 27 b0 58 10 00 00 00 30 35",
        "cc 60 00 27 b0 30 00 00 00 00 02 0d",
        "cc 70 00 cb b0 57 10 00 00 00 14 00 6e df"
      })
  void realPacketsAreReadAndWrittenToTheByte(String real) {
    byte[] datagram = bytes(real);

    assertThat(Packet.parse(datagram).map(Packet::bytes).map(PacketTest::hex))
        .contains(hex(datagram));
  }

  @Test
  void anAnswerHasTheNextKindAndTheSameSequenceNumber() {
    Packet takeoff = Packet.parse(new Packet(0x68, 0x54, 1, new byte[0]).bytes()).orElseThrow();

    assertThat(hex(takeoff.answer(new byte[] {0}).bytes()))
        .isEqualTo("cc600027b0540001 0000 7ddb".replace(" ", ""));
    assertThat(new Packet(0x48, 0x34, 0, new byte[0]).answer(new byte[0]).kind()).isEqualTo(0x90);
    assertThat(new Packet(0x88, 0x62, 0, new byte[0]).answer(new byte[0]).kind()).isEqualTo(0x50);
  }

  @Test
  void aChangedBitIsNoticed() {
    byte[] takeoff = bytes("cc 58 00 7c 68 54 00 e4 01 c2 16");
    for (int bit = 0; bit < takeoff.length * 8; bit++) {
      byte[] damaged = takeoff.clone();
      damaged[bit / 8] ^= (byte) (1 << bit % 8);

      assertThat(Packet.parse(damaged)).as("bit %d", bit).isEmpty();
    }
  }

  @Test
  void randomBytesAreNoPackets() {
    Random random = new Random(1);
    for (int i = 0; i < 100_000; i++) {
      byte[] datagram = new byte[random.nextInt(40)];
      random.nextBytes(datagram);
      if (datagram.length > 0) {
        datagram[0] = Packet.MARK;
      }
      Packet.parse(datagram).ifPresent(packet -> assertThat(packet.bytes()).isEqualTo(datagram));
    }
  }

  @Test
  void strayPacketsHaveTheLengthsThatUsersSee() {
    assertThat(StrayPacket.of(0)).hasSize(12).startsWith(0xcc);
    assertThat(StrayPacket.of(1)).hasSize(13).startsWith(0xcc);
    assertThat(StrayPacket.of(2)).hasSize(35).startsWith(0xcc);
    assertThat(Packet.parse(StrayPacket.of(300))).isPresent();
  }
}
