package tellosimulator.network;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static tellosimulator.testing.SimulatedDrone.address;

import java.nio.channels.ClosedChannelException;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(value = 30, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class InMemoryPortTest {

  private final InMemoryPort port = new InMemoryPort(address("192.168.10.1", 8889));

  @Test
  void whatIsDeliveredIsReceivedInOrder() throws Exception {
    port.deliver(address("192.168.10.2", 9000), "command");
    port.deliver(address("192.168.10.3", 9001), "takeoff");

    assertThat(port.receive())
        .isEqualTo(new DatagramPort.Received(address("192.168.10.2", 9000), "command"));
    assertThat(port.receive())
        .isEqualTo(new DatagramPort.Received(address("192.168.10.3", 9001), "takeoff"));
  }

  @Test
  void whatIsSentIsTakenOnce() {
    port.send(new byte[] {'o', 'k', (byte) 0xff}, address("192.168.10.2", 9000));

    assertThat(port.takeSent())
        .containsExactly(new InMemoryPort.Sent(address("192.168.10.2", 9000), "ok\u00ff"));
    assertThat(port.takeSent()).isEmpty();
  }

  @Test
  void aClosedPortStaysClosed() {
    port.close();

    assertThatThrownBy(port::receive).isInstanceOf(ClosedChannelException.class);
    assertThatThrownBy(port::receive).isInstanceOf(ClosedChannelException.class);
  }
}
