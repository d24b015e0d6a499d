package tellosimulator.protocol.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HexFormat;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.command.WireText;
import tellosimulator.testing.AppPackets;

class NamedPacketTest {

  private static NamedPacket of(String text) {
    return NamedPacket.of(WireText.encode(text)).orElseThrow();
  }

  /**
   * Real packets are from published logs (TelloPy 48, SMerrony/tello); the others were computed.
   */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          cc58007c6854000000b289                       | takeoff (app)
          cc600027685500020000c65b                     | land (app)
          cc6000276855000300019310                     | stop landing (app)
          cc600027705c00040002819c                     | flip b (app)
          cc600027705c000400095222                     | flip 9 (app)
          cc68005168580005000a000ec0                   | height limit 10 (app)
          cc7800bd685810080000007041b830               | attitude limit 15.0 (app)
          ccb0007f605000000000542a00d902000000000033da | rc 0 50 0 -100 (app)
          cc880024605000000000a434000118ca3a           | rc 0 250 0 0 (app)
          cc58007c4811000700cbdc                       | ssid? (app)
          cc58007c48990009006d8e                       | packet 0099 (app)
          cc58007c6854000000b288                       | damaged packet (app)
          cc                                           | damaged packet (app)
          """)
  void aPacketOfTheAppHasItsOrderAndItsValue(String hex, String words) {
    NamedPacket packet = NamedPacket.of(HexFormat.of().parseHex(hex)).orElseThrow();

    assertThat(packet.words()).isEqualTo(words);
    assertThat(packet.reply()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          cc60002790340000000072a5                         | exposure (app)        | ok
          cc600027b05400010001f4ca                         | takeoff (app)         | error
          cc7000cb9056100600001e00a330                     | height limit? (app)   | 30
          ccc800bf9011000700000c54454c4c4f2d3030303030312ef5 | ssid? (app)         | TELLO-000001
          cc8000529059100800000000c841ffde                 | attitude limit? (app) | 25.0
          """)
  void anAnswerHasTheReplyThatATextWouldGet(String hex, String words, String reply) {
    NamedPacket packet = NamedPacket.of(HexFormat.of().parseHex(hex)).orElseThrow();

    assertThat(packet.words()).isEqualTo(words);
    assertThat(packet.reply().orElseThrow().strip()).isEqualTo(reply);
  }

  @Test
  void anAnswerBelongsToItsQuestion() {
    assertThat(of(AppPackets.TAKEOFF_DONE).exchange())
        .isEqualTo(of(AppPackets.TAKEOFF).exchange())
        .isNotEqualTo(of(AppPackets.LAND_DONE).exchange());
    assertThat(of(AppPackets.ACKNOWLEDGEMENT).exchange())
        .isEqualTo(of(AppPackets.CONNECT).exchange());
    assertThat(of(AppPackets.CONNECT).words()).isEqualTo("conn_req (app)");
    assertThat(of(AppPackets.ACKNOWLEDGEMENT).reply()).contains("conn_ack");
  }

  @Test
  void aNotificationAnswersNothing() {
    assertThat(of(AppPackets.FLIGHT_DATA).words()).isEqualTo("flight data (app)");
    assertThat(of(AppPackets.FLIGHT_DATA).reply()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({
    "0x68, 0x54, true", // takeoff
    "0x48, 0x11, true", // name of the network
    "0x60, 0x50, true", // sticks
    "0x60, 0x25, false", // key picture
    "0x50, 0x46, false", // the time, which the drone has asked for
    "0x88, 0x62, false", // the drone's own packet, which TelloPy sends back
    "0x50, 0x63, false", // acknowledgement of a piece of a photo
    "0x48, 0x64, false", // all of a photo is there
    "0x50, 0x1050, false", // answer to the header of the log
    "0x48, 0x99, false", // unknown
  })
  void acknowledgementsAreNoCommands(int kind, int id, boolean command) {
    byte[] packet = new Packet(kind, id, 1, new byte[6]).bytes();

    assertThat(NamedPacket.of(packet).orElseThrow().command()).isEqualTo(command);
  }

  @Test
  void aTextIsNone() {
    assertThat(NamedPacket.of(WireText.encode("takeoff"))).isEmpty();
    assertThat(NamedPacket.of(new byte[0])).isEmpty();
    assertThat(NamedPacket.text(WireText.encode("battery?"))).isEqualTo("battery?");
  }

  @Test
  void thePortForTheVideoIsReplacedAndNothingElse() {
    byte[] replaced = VideoPort.replaced(WireText.encode(AppPackets.CONNECT), 11111);

    assertThat(VideoPort.of(WireText.encode(AppPackets.CONNECT))).hasValue(6038);
    assertThat(WireText.decode(replaced)).isEqualTo("conn_req:g+"); // 67 2b
    assertThat(VideoPort.of(WireText.encode("conn_req:"))).isEmpty();
    assertThat(VideoPort.of(WireText.encode("command"))).isEmpty();
  }
}
