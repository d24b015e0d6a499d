package tellosimulator.network;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static tellosimulator.testing.SteppedDrone.address;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedChannelException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

@EnabledOnOs(value = OS.LINUX, disabledReason = "only Linux has connected sockets beside others")
@Timeout(value = 60, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class UdpPortTest {

  private final BlockingQueue<InetSocketAddress> unreachable = new LinkedBlockingQueue<>();
  private UdpPort port;
  private DatagramSocket peer;
  private InetSocketAddress peersAddress;

  @BeforeEach
  void open() throws IOException {
    port = UdpPort.open(address("127.0.0.1", 0));
    peer = new DatagramSocket(address("127.0.0.1", 0));
    peer.setSoTimeout(20_000);
    peersAddress = (InetSocketAddress) peer.getLocalSocketAddress();
  }

  @AfterEach
  void close() {
    port.close();
    peer.close();
  }

  @Test
  void aConnectedSocketSendsFromTheSamePortAndGetsWhatItsPeerSends() throws IOException {
    UdpPort beside = port.beside(peersAddress, unreachable::add).orElseThrow();

    port.send(bytes("hello"), peersAddress);
    DatagramPacket packet = new DatagramPacket(new byte[100], 100);
    peer.receive(packet);
    assertThat(packet.getSocketAddress()).isEqualTo(port.address());

    peer.send(new DatagramPacket(bytes("from peer"), 9, port.address()));
    assertThat(receiveFrom(beside)).isEqualTo("from peer");
  }

  @Test
  void othersStillReachTheFirstSocketAndNobodyElseCanBindThePort() throws IOException {
    assertThat(port.beside(peersAddress, unreachable::add)).isPresent();
    try (DatagramSocket other = new DatagramSocket(address("127.0.0.1", 0))) {
      other.send(new DatagramPacket(bytes("other"), 5, port.address()));
      assertThat(receiveFrom(port)).isEqualTo("other");
    }
    DatagramSocket third = new DatagramSocket(null);
    third.setReuseAddress(true);
    assertThatThrownBy(() -> third.bind(port.address())).isInstanceOf(java.net.BindException.class);
    third.close();
  }

  @Test
  void aPeerThatReceivesNoMoreIsToldToWhoAsked() throws Exception {
    UdpPort beside = port.beside(peersAddress, unreachable::add).orElseThrow();
    peer.close();
    port.send(bytes("nobody there"), peersAddress);

    assertThat(receiveFrom(beside)).as("word of it in place of a datagram").isEmpty();
    assertThat(unreachable.poll()).isEqualTo(peersAddress);
    port.keepConnected(Optional.empty());
    assertThatThrownBy(() -> beside.receive(ByteBuffer.allocate(10)))
        .isInstanceOf(ClosedChannelException.class);
    assertThat(port.isConnectedTo(peersAddress)).isFalse();
  }

  @Test
  void socketsToTheSameHostStayAndThoseToOthersAreClosed() throws IOException {
    port.beside(peersAddress, unreachable::add);
    port.beside(address("127.0.0.3", 9), unreachable::add);

    port.keepConnected(Optional.of(peersAddress.getAddress()));

    assertThat(port.isConnectedTo(peersAddress)).isTrue();
    assertThat(port.isConnectedTo(address("127.0.0.3", 9))).isFalse();
  }

  /** Receives the next datagram; returns empty if the port reported something else. */
  private static String receiveFrom(UdpPort from) throws IOException {
    ByteBuffer buffer = ByteBuffer.allocate(100);
    from.receive(buffer);
    return StandardCharsets.ISO_8859_1.decode(buffer.flip()).toString();
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }
}
