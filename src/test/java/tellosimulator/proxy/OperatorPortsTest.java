package tellosimulator.proxy;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketException;
import org.junit.jupiter.api.Test;
import tellosimulator.network.UdpPort;
import tellosimulator.proxy.OperatorPorts.Opening;
import tellosimulator.testing.CapturedLog;

class OperatorPortsTest {

  private static final Opening NONE_LEFT =
      () -> {
        throw new SocketException("Too many open files");
      };

  private static InetSocketAddress operator(int port) {
    return new InetSocketAddress(InetAddress.getLoopbackAddress(), port);
  }

  @Test
  void thatThereIsNoSocketIsToldOnceUntilThereIsOneAgain() throws Exception {
    try (CapturedLog log = CapturedLog.of(OperatorPorts.class);
        OperatorPorts ports = new OperatorPorts()) {
      for (int i = 1; i <= 100; i++) {
        assertThat(ports.of(operator(i), NONE_LEFT)).isEmpty();
      }
      assertThat(log.next())
          .isEqualTo("Commands are lost, because there is no socket for them: Too many open files");
      assertThat(log.isEmpty()).isTrue();

      assertThat(ports.of(operator(1), () -> UdpPort.open(operator(0)))).isPresent();
      assertThat(ports.of(operator(2), NONE_LEFT)).isEmpty();
      assertThat(log.next()).contains("Too many open files");
    }
  }
}
