package tellosimulator.view.controls;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.testing.SteppedDrone.address;

import java.net.InetSocketAddress;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.view.text.Message;

class PortRulesTest {

  @Test
  void stateAndVideoCannotShareAPort() {
    assertThat(PortRules.streamPort(11111, 11111)).hasValue(Message.of("port.same", "11111"));
    assertThat(PortRules.streamPort(11112, 11111)).isEmpty();
    assertThat(PortRules.streamPort(88.5, 11111)).hasValue(Message.of("port.whole"));
  }

  @Test
  void twoDronesCannotListenOnTheSamePortOfAnAddress() {
    var own = List.of(address("127.0.0.1", 8879));
    var second = List.of(address("127.0.0.2", 8880));
    var third = List.of(address("127.0.0.1", 8881));
    var others = List.of(List.<InetSocketAddress>of(), second, third);

    assertThat(PortRules.command(8880, own, others)).isEmpty();
    assertThat(PortRules.command(8881, own, others)).hasValue(Message.of("port.other-drone", "3"));
    assertThat(PortRules.command(8879, own, others)).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({
    "8879, ''",
    "8889, port.operators",
    "8890, port.listening",
    "11111, port.listening",
    "9000, port.listening",
    "9001, port.listening"
  })
  void portsOfOperatorProgramsAreWarnedOf(int command, String key) {
    assertThat(PortRules.warning(command, new StreamPorts(9000, 9001)).map(Message::key).orElse(""))
        .isEqualTo(key);
  }
}
